// Protects: light finds its way through media that vary as the integrals along its rays say, by
// flights, by transmittance and by its steps, in every channel, whatever the cells.
#include "lxs/sdk/medium_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bsdf_statistics.h"
#include "lxs/sdk/medium.h"

namespace lxs::medium_field_test {
namespace {

constexpr int kDraws = 100'000;

/// Layers across z, the same along x and y, so that many rays have one transmittance.
class Layers final : public MediumField {
  public:
    MediumCoefficients at(const Vec3& p, const Wavelengths*) const override {
        const float wave = 0.5f + 0.5f * std::sin(9 * p.z);
        return {Rgb(0.2f, 0.0f, 1.0f) * wave, Rgb(0.5f, 1.0f, 2.0f) * (wave * wave), Rgb(0.0f)};
    }
    bool scatters() const override { return true; }
};

void run_serially(int count, const std::function<void(int)>& job) {
    for (int i = 0; i < count; ++i)
        job(i);
}

Medium layered_medium() {
    Medium medium(std::make_shared<Layers>(), Rgb(0.0f), IndexCurve{});
    medium.bound(Bounds(Vec3(-1, -1, -1.5f), Vec3(1, 1, 1.5f)), run_serially);
    return medium;
}

/// From below the bounds to beyond them, past (x, y, 0).
struct TestRay {
    Vec3 origin, direction;
};
TestRay ray_past(float x, float y) {
    const Vec3 direction = Vec3(0.1f, 0.2f, 1).normalized();
    return {Vec3(x, y, 0) - direction * 2, direction};
}

Rgb extinction_at(const Vec3& p) {
    if (std::abs(p.x) > 1 || std::abs(p.y) > 1 || std::abs(p.z) > 1.5f) return Rgb(0.0f);
    const MediumCoefficients here = Layers().at(p, nullptr);
    return here.absorption + here.scattering;
}

/// By quadrature.
Imath::V3d expected_transmittance(const TestRay& ray, double length) {
    constexpr int kSteps = 100'000;
    Imath::V3d depth(0.0);
    for (int i = 0; i < kSteps; ++i) {
        const auto t = float((i + 0.5) / kSteps * length);
        depth += Imath::V3d(extinction_at(ray.origin + ray.direction * t)) * (length / kSteps);
    }
    return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
}

/// Means of draws of three channels, compared at five standard errors.
class Means {
  public:
    void add(const Imath::V3d& value) {
        sum_ += value;
        squares_ += value * value;
        ++count_;
    }
    void expect(const Imath::V3d& expected, const char* what) const {
        for (int c = 0; c < 3; ++c) {
            const double mean = sum_[c] / count_;
            const double error = std::sqrt((squares_[c] / count_ - mean * mean) / count_);
            EXPECT_NEAR(mean, expected[c], 5 * error + 1e-4) << what << ", channel " << c;
            EXPECT_LT(error, 0.01) << what;
        }
    }

  private:
    Imath::V3d sum_{0.0}, squares_{0.0};
    int count_ = 0;
};

TEST(MediumField, TransmittanceIsThatOfTheIntegral) {
    const Medium medium = layered_medium();
    UniformSource random(1);
    for (const float length : {1.2f, 2.3f, 9.0f}) {
        Means passed;
        for (int i = 0; i < kDraws; ++i) {
            const TestRay ray = ray_past(random.pair().x * 0.2f, random.pair().y * 0.2f);
            passed.add(Imath::V3d(medium.transmittance(ray.origin, ray.direction, length)));
        }
        passed.expect(expected_transmittance(ray_past(0, 0), double(length)), "passed");
    }
}

TEST(MediumField, StepsAreRightAtEveryDistance) {
    const Medium medium = layered_medium();
    UniformSource random(2);
    const TestRay ray = ray_past(0, 0);
    constexpr std::array<float, 4> kDistances{0.8f, 1.7f, 2.6f, 5.0f};
    std::array<Means, kDistances.size()> passed;
    std::vector<TransmittanceStep> steps;
    for (int i = 0; i < kDraws; ++i) {
        medium.transmittance_steps(ray.origin, ray.direction, 5, random.pair().x, steps);
        for (std::size_t d = 0; d < kDistances.size(); ++d) {
            Rgb there(1.0f);
            for (const TransmittanceStep& step : steps) {
                if (step.from <= kDistances[d]) there = step.passed;
            }
            passed[d].add(Imath::V3d(there));
        }
    }
    for (std::size_t d = 0; d < kDistances.size(); ++d)
        passed[d].expect(expected_transmittance(ray, double(kDistances[d])), "steps");
}

/// What flights bring to collisions before a distance, and past the end.
TEST(MediumField, FlightsCollideWhereLightDoes) {
    const Medium medium = layered_medium();
    UniformSource random(3);
    const TestRay ray = ray_past(0, 0);
    const Rgb carried(0.5f, 1.0f, 0.2f);
    constexpr float kHalfWay = 1.9f, kLength = 2.7f;
    Means early, all, through;
    for (int i = 0; i < kDraws; ++i) {
        const Flight flight =
            medium.sample_flight(ray.origin, ray.direction, kLength, carried, random.pair());
        const Imath::V3d weight(flight.weight);
        const Vec3 place = ray.origin + ray.direction * flight.distance;
        const Imath::V3d collided =
            flight.collides ? weight * Imath::V3d(extinction_at(place)) : Imath::V3d(0.0);
        all.add(collided);
        early.add(flight.distance < kHalfWay ? collided : Imath::V3d(0.0));
        through.add(flight.collides ? Imath::V3d(0.0) : weight);
    }
    const Imath::V3d one(1.0);
    early.expect(one - expected_transmittance(ray, double(kHalfWay)), "early");
    all.expect(one - expected_transmittance(ray, double(kLength)), "all");
    through.expect(expected_transmittance(ray, double(kLength)), "through");
}

/// Shadow rays start where light collides: what they meet has nothing to do with how they came
/// there.
TEST(MediumField, TransmittanceFromCollisionsIsThatOfTheIntegral) {
    const Medium medium = layered_medium();
    UniformSource random(4);
    Means difference;
    for (int i = 0; i < kDraws; ++i) {
        const TestRay ray = ray_past(random.pair().x * 0.2f, random.pair().y * 0.2f);
        const Flight flight =
            medium.sample_flight(ray.origin, ray.direction, 9, Rgb(1.0f), random.pair());
        if (!flight.collides) continue;
        const TestRay shadow{ray.origin + ray.direction * flight.distance,
                             Vec3(random.pair().x - 0.5f, random.pair().y - 0.5f, -1).normalized()};
        const Rgb passed = medium.transmittance(shadow.origin, shadow.direction, 9);
        Imath::V3d depth(0.0);
        for (int k = 0; k < 200; ++k) {
            const float t = (float(k) + 0.5f) * 0.02f;
            depth += Imath::V3d(extinction_at(shadow.origin + shadow.direction * t)) * 0.02;
        }
        const Imath::V3d expected(std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z));
        difference.add(Imath::V3d(passed) - expected);
    }
    difference.expect(Imath::V3d(0.0), "difference");
}

/// So dense in one place, and nothing beside it, that flights would collide in vain for ever.
class Needle final : public MediumField {
  public:
    MediumCoefficients at(const Vec3& p, const Wavelengths*) const override {
        return {Rgb(p.length() < 0.02f ? 1e30f : 0.0f), Rgb(0.1f), Rgb(0.0f)};
    }
    bool scatters() const override { return true; }
};

TEST(MediumField, FlightsEndHoweverDenseACellIs) {
    Medium medium(std::make_shared<Needle>(), Rgb(0.0f), IndexCurve{});
    medium.bound(Bounds(Vec3(-1), Vec3(1)), run_serially);
    UniformSource random(5);
    Means beside;
    for (int i = 0; i < 1500; ++i) {
        const Vec3 origin(0.022f + 1e-4f * random.pair().x, 0, -1);
        EXPECT_EQ(medium.transmittance(Vec3(0, 0, -1), Vec3(0, 0, 1), 2), Rgb(0.0f));
        beside.add(Imath::V3d(medium.transmittance(origin, Vec3(0, 0, 1), 2)));
        const Flight flight =
            medium.sample_flight(origin, Vec3(0, 0, 1), 2, Rgb(1.0f), random.pair());
        EXPECT_NEAR(flight.weight.x, flight.collides ? 10 : 1, 1e-2f);
    }
    beside.expect(Imath::V3d(std::exp(-0.2)), "beside");
}

/// A grid of more cells than 128 a side: every seventh layer is dense, linear between cells'
/// middles.
class Sheets final : public MediumField {
  public:
    static constexpr float kCell = 2.0f / 300;

    MediumCoefficients at(const Vec3& p, const Wavelengths*) const override {
        const float place = std::fmod((p.z + 1) / kCell + 3, 7.0f) - 3.5f;  // of the next middle
        return {Rgb(8 * std::max(0.0f, 1 - std::abs(place))), Rgb(0.0f), Rgb(0.0f)};
    }
    bool scatters() const override { return false; }
    float cell_size() const override { return kCell; }
};

TEST(MediumField, WhatIsFineAsItsCellsIsNotCut) {
    Medium medium(std::make_shared<Sheets>(), Rgb(0.0f), IndexCurve{});
    medium.bound(Bounds(Vec3(-1), Vec3(1)), run_serially);
    UniformSource random(6);
    Means passed;
    for (int i = 0; i < kDraws; ++i) {
        const Vec3 origin(random.pair().x, random.pair().y, -1.5f);
        passed.add(Imath::V3d(medium.transmittance(origin, Vec3(0, 0, 1), 9)));
    }
    passed.expect(Imath::V3d(std::exp(-43 * 8 * double(Sheets::kCell))), "passed");
}

/// Layers that shine where they are dim, but for a part that is bright and dense.
class ShiningLayers final : public MediumField {
  public:
    MediumCoefficients at(const Vec3& p, const Wavelengths* none) const override {
        return Layers().at(p, none);
    }
    bool scatters() const override { return true; }
    Rgb emission(const Vec3& p, const Wavelengths*) const override {
        return Rgb(1 - std::sin(9 * p.z), p.z > 0.5f ? 3 : 0, 1);
    }
    bool emits() const override { return true; }
};

TEST(MediumField, ItsOwnLightIsThatOfTheIntegral) {
    Medium medium(std::make_shared<ShiningLayers>(), Rgb(0.0f), IndexCurve{});
    medium.bound(Bounds(Vec3(-1, -1, -1.5f), Vec3(1, 1, 1.5f)), run_serially);
    UniformSource random(7);
    for (const float length : {1.2f, 2.3f, 9.0f}) {
        const TestRay middle = ray_past(0, 0);
        constexpr int kSteps = 20'000;
        Imath::V3d expected(0.0), depth(0.0);
        for (int i = 0; i < kSteps; ++i) {
            const double step = double(length) / kSteps;
            const Vec3 p = middle.origin + middle.direction * float((i + 0.5) * step);
            if (std::abs(p.z) > 1.5f) continue;
            const Imath::V3d here(extinction_at(p));
            const Imath::V3d passed(std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z));
            expected += Imath::V3d(ShiningLayers().emission(p, nullptr)) * passed * step;
            depth += here * step;
        }
        Means emitted;
        for (int i = 0; i < kDraws; ++i) {
            const TestRay ray = ray_past(random.pair().x * 0.2f, random.pair().y * 0.2f);
            emitted.add(Imath::V3d(medium.emitted(ray.origin, ray.direction, length)));
        }
        emitted.expect(expected, "emitted");
    }
    EXPECT_TRUE(is_black(medium.emitted(Vec3(0, 0, 5), Vec3(1, 0, 0), 100)));
    EXPECT_TRUE(is_black(medium.emission_at(Vec3(0, 0, 5))));
}

TEST(MediumField, ItsOwnLightInAnEvenMediumIsExact) {
    const Medium medium(MediumCoefficients{Rgb(0, 1, 1e-8f), Rgb(0, 1, 0), Rgb(0.0f), Rgb(1, 2, 3)},
                        IndexCurve{});
    const Rgb sent = medium.emitted(Vec3(0.0f), Vec3(0, 0, 1), 2);
    EXPECT_NEAR(sent.x, 2, 1e-6f);
    EXPECT_NEAR(sent.y, 1 - std::exp(-4.0f), 1e-6f);
    EXPECT_NEAR(sent.z, 6, 1e-5f);
    const Rgb through = medium.emitted(Vec3(0.0f), Vec3(0, 0, 1), INFINITY);
    EXPECT_NEAR(through.y, 1, 1e-6f);
}

TEST(MediumField, IsNothingBeyondItsBounds) {
    const Medium medium = layered_medium();
    EXPECT_EQ(medium.transmittance(Vec3(5, 0, 0), Vec3(0, 0, 1), 100), Rgb(1.0f));
    EXPECT_EQ(medium.transmittance(Vec3(0, 0, 5), Vec3(1, 0, 0), 100), Rgb(1.0f));
    EXPECT_TRUE(is_black(medium.scattering_at(Vec3(0, 0, 5))));
    const Flight flight =
        medium.sample_flight(Vec3(0, 0, 2), Vec3(0, 0, 1), 7, Rgb(1.0f), Vec2(0.3f));
    EXPECT_FALSE(flight.collides);
    EXPECT_EQ(flight.distance, 7);
    EXPECT_EQ(flight.weight, Rgb(1.0f));
}

}  // namespace
}  // namespace lxs::medium_field_test
