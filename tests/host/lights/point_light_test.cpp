// Point, spot and distant lights: closed forms, and LuxRender's scales.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "light_cases.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs::test::point_light_test {
namespace {

constexpr double kPi = std::numbers::pi;

Rgb direct(const Light& light, const Vec3& p) {
    DirectSample s;
    if (!light.sample_direct(p, Vec3(0, 0, 1), Vec2(0.5f), s)) return Rgb(0.0f);
    EXPECT_TRUE(s.delta);
    EXPECT_EQ(s.pdf, 1);
    EXPECT_EQ(light.pdf_direct(p, Vec3(0, 0, 1), s.wi, Vec3(0.0f), Vec3(0.0f), 0), 0);
    return s.radiance;
}

TEST(PointLight, InverseSquareOfIntensity) {
    const auto light =
        make_one("point",
                 {numbers("color", "L", {30, 20, 10}), numbers("point", "from", {1, 0, 0}),
                  numbers("float", "gain", {2})},
                 translation(0, 0, 2));
    const Rgb e = direct(*light, Vec3(1, 0, 0));
    const Rgb colour = colour_of_illuminant(Rgb(30, 20, 10));
    EXPECT_FLOAT_EQ(e.x, colour.x / 2);
    EXPECT_FLOAT_EQ(e.z, colour.z / 2);
    EXPECT_NEAR(light->power(), 4 * kPi * 2 * luminance(colour), 1e-2);
    EmissionSample s;
    ASSERT_TRUE(light->sample_emission({0.1f, 0.2f, 0.3f, 0.4f}, s));
    EXPECT_NEAR(luminance(s.power), light->power(), 1e-2);
    EXPECT_EQ(s.normal, Vec3(0.0f));
    EXPECT_FALSE(light->at_infinity());
}

TEST(PointLight, PowerAndEfficacySetTheFlux) {
    const auto light =
        make_one("point", {numbers("color", "L", {30, 20, 10}), numbers("float", "power", {60}),
                           numbers("float", "efficacy", {15}), numbers("float", "gain", {2})});
    EXPECT_NEAR(light->power(), 2 * 900, 0.1);
}

TEST(SpotLight, FalloffAndPower) {
    const double outer = 25 * kPi / 180, inner = 17 * kPi / 180;
    const auto light =
        make_one("spot", {numbers("color", "L", {80, 80, 80}), numbers("point", "from", {0, 0, 0}),
                          numbers("point", "to", {0, 0, 1}), numbers("float", "coneangle", {25}),
                          numbers("float", "conedeltaangle", {8})});
    const auto at = [&](double angle) {
        return direct(*light, Vec3(float(std::sin(angle)), 0, float(std::cos(angle)))).x;
    };
    EXPECT_NEAR(at(0), 80, 1e-3);
    EXPECT_NEAR(at(inner - 0.01), 80, 1e-3);
    EXPECT_EQ(at(outer + 0.001), 0);
    const double middle = (inner + outer) / 2;
    const double share = (std::cos(middle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(at(middle), 80 * std::pow(share, 4), 1e-2);
    const double closed =
        2 * kPi * 80 * ((1 - std::cos(inner)) + (std::cos(inner) - std::cos(outer)) / 5);
    EXPECT_NEAR(light->power() / closed, 1, 1e-5);
}

// Every photon of a spot has the same power: the falloff is sampled exactly.
TEST(SpotLight, PhotonsFollowTheFalloff) {
    const auto light = make_one(
        "spot", {numbers("float", "coneangle", {40}), numbers("float", "conedeltaangle", {30})});
    Random random(31);
    constexpr int kCount = 100000;
    int inside = 0;
    for (int i = 0; i < kCount; ++i) {
        EmissionSample s;
        ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
        ASSERT_FLOAT_EQ(luminance(s.power), light->power());
        if (s.ray.direction.z > std::cos(10 * kPi / 180)) ++inside;
    }
    const double share = 2 * kPi * (1 - std::cos(10 * kPi / 180)) / light->power();
    EXPECT_NEAR(inside, share * kCount, 4 * std::sqrt(share * (1 - share) * kCount));
}

TEST(SpotLight, SmoothstepOfPbrt) {
    const double outer = 40 * kPi / 180, inner = 10 * kPi / 180;
    const auto light =
        make_one("spot", {numbers("color", "L", {80, 80, 80}), numbers("float", "coneangle", {40}),
                          numbers("float", "conedeltaangle", {30}), text("falloff", "smoothstep")});
    const auto share = [&](double angle) {
        return (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    };
    for (const double degrees : {12.0, 20.0, 30.0, 38.0}) {
        const double angle = degrees * kPi / 180, s = share(angle);
        EXPECT_NEAR(direct(*light, Vec3(float(std::sin(angle)), 0, float(std::cos(angle)))).x,
                    80 * s * s * (3 - 2 * s), 2e-3);
    }
    const double closed =
        2 * kPi * 80 * ((1 - std::cos(inner)) + (std::cos(inner) - std::cos(outer)) / 2);
    EXPECT_NEAR(light->power() / closed, 1, 1e-5);
    // Photons have the same power each, and as many go within an angle as its share of the light.
    Random random(37);
    constexpr int kCount = 100000;
    int within_25 = 0;
    for (int i = 0; i < kCount; ++i) {
        EmissionSample s;
        ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
        ASSERT_FLOAT_EQ(luminance(s.power), light->power());
        if (s.ray.direction.z > std::cos(25 * kPi / 180)) ++within_25;
    }
    const double s = share(25 * kPi / 180), all = 0.5 * (std::cos(inner) - std::cos(outer));
    const double beyond = all * s * s * s * (2 - s);
    const double expected = 1 - beyond / (1 - std::cos(inner) + all);
    EXPECT_NEAR(within_25, expected * kCount, 4 * std::sqrt(expected * (1 - expected) * kCount));
}

// LuxRender 1.9's image of a floor under a distant light with L = 2: 20840 lx facing it.
TEST(DistantLight, LuxRendersScale) {
    const auto light =
        make_one("distant", {numbers("color", "L", {2, 2, 2}), numbers("point", "from", {1, -1, 2}),
                             numbers("point", "to", {0, 0, 0})});
    EXPECT_NEAR(direct(*light, Vec3(0.0f)).y / 20840, 1, 0.005);
    DirectSample s;
    ASSERT_TRUE(light->sample_direct(Vec3(0.0f), {}, Vec2(0.5f), s));
    EXPECT_NEAR((s.wi - Vec3(1, -1, 2).normalized()).length(), 0, 1e-6);
    EXPECT_TRUE(std::isinf(s.distance));
    EXPECT_TRUE(is_black(light->escaped(s.wi)));
}

TEST(DistantLight, DiskSpreadsTheIrradiance) {
    const double theta = 5 * kPi / 180;
    const auto light =
        make_one("distant", {numbers("float", "theta", {5}), numbers("point", "from", {0, 0, 1}),
                             numbers("point", "to", {0, 0, 0})});
    EXPECT_TRUE(light->at_infinity());
    const double solid_angle = 2 * kPi * (1 - std::cos(theta));
    EXPECT_NEAR(light->escaped(Vec3(0, 0, 1)).y * solid_angle * solid_angle, 1, 1e-4);
    const float beyond = float(theta) + 0.001f;
    EXPECT_TRUE(is_black(light->escaped(Vec3(std::sin(beyond), 0, std::cos(beyond)))));
}

}  // namespace
}  // namespace lxs::test::point_light_test
