// Protects: a medium that shines lights places beside it and within it as its integral over the
// volume says, its directions are as dense as it tells, and its photons carry all of its power.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "light_cases.h"
#include "lxs/sdk/medium.h"
#include "lxs/sdk/warp.h"

namespace lxs::medium_light_test {
namespace {

constexpr int kDraws = 100'000;
constexpr float kRadius = 0.8f;
const Vec3 kCentre(0.3f, -0.2f, 2.0f);
constexpr double kVolume = 4 * double(kPi) / 3 * 0.8 * 0.8 * 0.8;

void run_serially(int count, const std::function<void(int)>& job) {
    for (int i = 0; i < count; ++i)
        job(i);
}

/// A ball in which the medium is, within a box of `room` times its size.
std::unique_ptr<PlacedLight> ball_of(std::shared_ptr<Medium> medium, float room = 1) {
    const Bounds bounds(kCentre - Vec3(kRadius * room), kCentre + Vec3(kRadius * room));
    if (medium->varies()) medium->bound(bounds, run_serially);
    return make_medium_light(
        {},
        {std::move(medium), bounds,
         [](const Vec3& p, const Vec3&) { return (p - kCentre).length() < kRadius; }},
        run_serially);
}

/// Of 2 in each channel.
std::shared_ptr<Medium> even_glow() {
    return std::make_shared<Medium>(MediumCoefficients{Rgb(0.5f), Rgb(0.0f), Rgb(0.0f), Rgb(2.0f)},
                                    IndexCurve{});
}

/// A hot place beside the middle of the ball.
class HotPlace final : public MediumField {
  public:
    MediumCoefficients at(const Vec3&, const Wavelengths*) const override { return {}; }
    bool scatters() const override { return false; }
    Rgb emission(const Vec3& p, const Wavelengths*) const override {
        const Vec3 off = p - kCentre - Vec3(0.3f, 0.1f, -0.2f);
        return Rgb(50 * std::exp(-20 * off.length2()));
    }
    bool emits() const override { return true; }
};

struct Estimate {
    double mean = 0, error = 0;
};

/// Of `value(random)`.
template <class Value>
Estimate estimate(std::uint64_t seed, const Value& value) {
    test::Random random(seed);
    double sum = 0, squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double x = value(random);
        sum += x;
        squares += x * x;
    }
    const double mean = sum / kDraws;
    return {mean, std::sqrt((squares / kDraws - mean * mean) / kDraws)};
}

/// At five standard errors, which are at most 1 %.
void expect_mean(const Estimate& found, double expected, const std::string& what) {
    EXPECT_NEAR(found.mean, expected, 5 * found.error + 1e-3 * expected) << what;
    EXPECT_LT(found.error, 0.01 * expected) << what;
}

Estimate irradiance(const Light& light, const Vec3& p, const Vec3& n) {
    return estimate(1, [&](test::Random& random) {
        DirectSample s;
        const float u = random();
        if (!light.sample_direct(p, n, Vec2(u, random()), s)) return 0.0;
        EXPECT_FALSE(s.delta);
        return double(s.radiance.x * std::max(0.0f, s.wi.dot(n)) / s.pdf);
    });
}

/// What comes from a ball with the same everywhere is what would come from its centre, as
/// Newton's gravity.
TEST(MediumLight, AnEvenBallLightsAPlaneAsAPointWould) {
    for (const float room : {1.0f, 2.5f}) {
        const auto light = ball_of(even_glow(), room);
        for (const float distance : {0.85f, 2.0f, 40.0f}) {
            const Vec3 p = kCentre - Vec3(0, 0, distance);
            expect_mean(irradiance(*light, p, Vec3(0, 0, 1)),
                        2 * kVolume / (double(distance) * double(distance)),
                        std::to_string(distance));
        }
    }
}

/// From its centre the light is 2 times the radius in each direction.
TEST(MediumLight, LightIsBoundedWithinIt) {
    const auto light = ball_of(even_glow());
    const auto fluence = estimate(2, [&](test::Random& random) {
        DirectSample s;
        const float u = random();
        if (!light->sample_direct(kCentre, Vec3(0.0f), Vec2(u, random()), s)) return 0.0;
        return double(s.radiance.y / s.pdf);
    });
    expect_mean(fluence, 4 * double(kPi) * 2 * double(kRadius), "at the centre");
}

TEST(MediumLight, AHotPlaceLightsAsItsIntegralSays) {
    const auto light =
        ball_of(std::make_shared<Medium>(std::make_shared<HotPlace>(), Rgb(0.0f), IndexCurve{}));
    const Vec3 p(0.3f, 0.1f, 0.9f), n = Vec3(0.2f, 0.1f, 1).normalized();
    constexpr int kSide = 160;
    double expected = 0;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const int x = i % kSide, y = i / kSide % kSide, z = i / kSide / kSide;
        const Vec3 part{float(x), float(y), float(z)};
        const Vec3 off = ((part + Vec3(0.5f)) * (2.0f / kSide) - Vec3(1.0f)) * kRadius;
        if (off.length() >= kRadius) continue;
        const Vec3 to = kCentre + off - p;
        const double squared = double(to.length2());
        expected += double(HotPlace().emission(kCentre + off, nullptr).x) *
                    std::max(0.0, double(to.dot(n)) / std::sqrt(squared)) / squared;
    }
    const double side = 2 * double(kRadius) / kSide;
    expect_mean(irradiance(*light, p, n), expected * side * side * side, "beside it");
}

/// The integral of p q / (p + q) over each octant, by its directions, of density p, and by even
/// ones, of q.
TEST(MediumLight, DirectionsAreAsDenseAsItTells) {
    const auto light =
        ball_of(std::make_shared<Medium>(std::make_shared<HotPlace>(), Rgb(0.0f), IndexCurve{}));
    constexpr double kEven = 1 / (4 * double(kPi));
    const auto in = [](int octant, const Vec3& w) {
        return octant == (w.x > 0) + 2 * (w.y > 0) + 4 * (w.z > 0);
    };
    for (const Vec3& p : {kCentre, kCentre + Vec3(0.5f, 0.5f, 0.1f)}) {
        const auto told = [&](const Vec3& w) {
            return double(light->pdf_direct(p, Vec3(0.0f), w, {}, {}, 0));
        };
        for (int octant = 0; octant < 8; ++octant) {
            const auto drawn = estimate(3, [&](test::Random& random) {
                DirectSample s;
                const float u = random();
                if (!light->sample_direct(p, Vec3(0.0f), Vec2(u, random()), s)) return 0.0;
                EXPECT_NEAR(told(s.wi), double(s.pdf), 1e-4 * double(s.pdf));
                return in(octant, s.wi) ? kEven / (kEven + told(s.wi)) : 0.0;
            });
            const auto even = estimate(4, [&](test::Random& random) {
                const float z = 1 - 2 * random(), angle = 2 * kPi * random();
                const float r = std::sqrt(std::max(0.0f, 1 - z * z));
                const Vec3 w(r * std::cos(angle), r * std::sin(angle), z);
                return in(octant, w) ? told(w) / (kEven + told(w)) : 0.0;
            });
            EXPECT_NEAR(drawn.mean, even.mean, 5 * std::hypot(drawn.error, even.error)) << octant;
            EXPECT_LT(std::hypot(drawn.error, even.error), 1e-3) << octant;
        }
    }
}

TEST(MediumLight, PhotonsCarryItsPower) {
    const auto light = ball_of(even_glow(), 1.5f);
    const double power = 4 * double(kPi) * 2 * kVolume;
    std::array<double, 2> up{};
    const auto carried = estimate(20, [&](test::Random& random) {
        EmissionSample e;
        const PrimaryPoint u{random(), random(), random(), random()};
        if (!light->sample_emission(u, e)) return 0.0;
        EXPECT_LT((e.ray.origin - kCentre).length(), kRadius);
        up[e.ray.direction.y > 0] += double(e.power.x) / kDraws;
        return double(e.power.x);
    });
    expect_mean(carried, power, "photons");
    EXPECT_NEAR(up[0], up[1], 0.02 * power);
    EXPECT_NEAR(light->power(), power, 0.02 * power);
}

}  // namespace
}  // namespace lxs::medium_light_test
