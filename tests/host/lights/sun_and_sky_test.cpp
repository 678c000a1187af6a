// Sun and sky: brightness and colour of LuxRender 1.9's images, horizon, transforms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "light_cases.h"

namespace lxs::test::sun_and_sky_test {
namespace {

constexpr double kPi = std::numbers::pi;

// Irradiances, lx in the scene's colours, that LuxRender 1.9's images imply for a floor under sun
// (0.5, -0.6, 0.7) at turbidity 2.2.
const Rgb kLuxrenderSun(68190, 56580, 47320);
const Rgb kLuxrenderSky(20480, 28410, 50110);

ParameterValue sundir(double x, double y, double z) {
    return numbers("vector", "sundir", {x, y, z});
}

Rgb irradiance(const Light& light, const Vec3& n) {
    constexpr std::size_t kSide = 128;
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
        const std::size_t row = i / kSide, column = i % kSide;
        const Vec2 u((float(column) + 0.5f) / kSide, (float(row) + 0.5f) / kSide);
        DirectSample s;
        if (light.sample_direct(Vec3(0.0f), n, u, s))
            sum += Imath::V3d(s.radiance) * double(std::max(0.0f, s.wi ^ n) / s.pdf);
    }
    return Rgb(sum / double(kSide * kSide));
}

TEST(Sun, IrradianceOfLuxRendersSun) {
    const auto light =
        make_one("sun", {sundir(0.5, -0.6, 0.7), numbers("float", "turbidity", {2.2})});
    const Rgb e = irradiance(*light, Vec3(0, 0, 1));
    EXPECT_NEAR(e.x / kLuxrenderSun.x, 1, 0.02);
    EXPECT_NEAR(e.y / kLuxrenderSun.y, 1, 0.02);
    EXPECT_NEAR(e.z / kLuxrenderSun.z, 1, 0.02);
}

TEST(Sun, SizeOfItsDisk) {
    for (const double size : {1.0, 10.0}) {
        const auto light = make_one("sun", {sundir(0, 0, 1), numbers("float", "relsize", {size})});
        const double radius = size * 695500.0 / 149600000.0;
        const auto seen_at = [&](double angle) {
            return light->escaped(Vec3(float(std::sin(angle)), 0, float(std::cos(angle))));
        };
        EXPECT_FALSE(is_black(seen_at(radius * 0.99)));
        EXPECT_TRUE(is_black(seen_at(radius * 1.01)));
    }
}

TEST(Sun, RedAndDimTowardsTheHorizonThenGone) {
    float last = std::numeric_limits<float>::infinity();
    for (const double z : {1.0, 0.5, 0.1, 0.01, 1e-6}) {
        const double x = std::sqrt(1 - z * z);
        const auto light = make_one("sun", {sundir(x, 0, z)});
        const Rgb l = light->escaped(Vec3(float(x), 0, float(z)).normalized());
        EXPECT_TRUE(std::isfinite(l.x) && l.x >= 0 && std::isfinite(l.z) && l.z >= 0) << z;
        EXPECT_LT(luminance(l), last);
        last = luminance(l);
        if (z < 0.2) {
            EXPECT_GT(l.x, l.z);
        }
    }
    for (const double z : {-0.001, -0.3}) {
        RecordedDiagnostics diagnostics;
        const Lights lights = make("sun", {sundir(1, 0, z)}, diagnostics);
        EXPECT_EQ(lights[0]->power(), 0);
        ASSERT_EQ(diagnostics.warnings.size(), 1u);
        EXPECT_EQ(diagnostics.warnings[0], "the sun stands below the horizon and sends no light");
        EmissionSample s;
        EXPECT_FALSE(lights[0]->sample_emission({0.5f, 0.5f, 0.5f, 0.5f}, s));
    }
}

TEST(Sky, IrradianceOfLuxRendersSky) {
    const auto light =
        make_one("sky", {sundir(0.5, -0.6, 0.7), numbers("float", "turbidity", {2.2})});
    const Rgb e = irradiance(*light, Vec3(0, 0, 1));
    EXPECT_NEAR(e.x / kLuxrenderSky.x, 1, 0.04);
    EXPECT_NEAR(e.y / kLuxrenderSky.y, 1, 0.04);
    EXPECT_NEAR(e.z / kLuxrenderSky.z, 1, 0.04);
    EXPECT_GT(e.z, e.x) << "the sky is blue";
}

/// LuxRender's images show it: see make_sky_lights.
TEST(Sky, ALongerSunDirectionBrightensTheSunsSide) {
    for (const char* plugin : {"sky", "sky2"}) {
        const auto unit = make_one(plugin, {sundir(0.6, 0, 0.8)});
        const auto longer = make_one(plugin, {sundir(0.66, 0, 0.88)});
        const auto ratio = [&](const Vec3& w) {
            return luminance(longer->escaped(w)) / luminance(unit->escaped(w));
        };
        EXPECT_GT(ratio(Vec3(0.8f, 0, 0.6f)), 1.1) << plugin;
        EXPECT_LT(ratio(Vec3(-0.8f, 0, 0.6f)), ratio(Vec3(0.8f, 0, 0.6f))) << plugin;
    }
}

// Below its horizon the sky goes on at the horizon's brightness: LuxRender's images show it.
TEST(Sky, ContinuesBelowTheHorizon) {
    const auto light = make_one("sky", {sundir(0, 0, 1)});
    const Rgb above = light->escaped(Vec3(1, 0, 0.0005f).normalized());
    const Rgb below = light->escaped(Vec3(1, 0, -0.0005f).normalized());
    EXPECT_NEAR(above.y / below.y, 1, 0.01);
    EXPECT_FALSE(is_black(light->escaped(Vec3(0, 0, -1))));
}

class EverySky : public testing::TestWithParam<const char*> {};

TEST_P(EverySky, FiniteForEverySunAndTurbidity) {
    for (const double turbidity : {1.0, 1.7, 2.0, 10.0, 64.0}) {
        for (const double z : {1.0, 0.3, 0.0, -0.01, -1.0}) {
            const auto light = make_one(GetParam(), {sundir(std::sqrt(1 - z * z), 0, z),
                                                     numbers("float", "turbidity", {turbidity})});
            EXPECT_TRUE(std::isfinite(light->power()) && light->power() >= 0);
            Random random(43);
            for (int i = 0; i < 500; ++i) {
                DirectSample s;
                if (!light->sample_direct(Vec3(0.0f), {}, Vec2(random(), random()), s)) continue;
                ASSERT_TRUE(std::isfinite(max_component(s.radiance) / s.pdf));
                ASSERT_TRUE(s.radiance.x >= 0 && s.radiance.y >= 0 && s.radiance.z >= 0);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, EverySky, testing::Values("sky", "sky2"));

TEST(Sky, CoefficientsScaleTheModel) {
    const auto plain = make_one("sky", {sundir(0, 0, 1)});
    const auto old_name = make_one("sky", {sundir(0, 0, 1), numbers("float", "cconst", {3})});
    const auto new_name =
        make_one("sky", {sundir(0, 0, 1), numbers("float", "sunhalobrightness", {3})});
    const Vec3 w = Vec3(1, 0, 0.3f).normalized();
    EXPECT_NE(plain->escaped(w).y, new_name->escaped(w).y);
    EXPECT_EQ(old_name->escaped(w).y, new_name->escaped(w).y);
}

// A disk of another size gives as much light.
TEST(Sun, SizeDoesNotChangeItsIrradiance) {
    const auto small = make_one("sun", {sundir(0.6, 0, 0.8)});
    const auto large = make_one("sun", {sundir(0.6, 0, 0.8), numbers("float", "relsize", {10})});
    EXPECT_NEAR(
        irradiance(*large, Vec3(0.6f, 0, 0.8f)).y / irradiance(*small, Vec3(0.6f, 0, 0.8f)).y, 1,
        0.002);
}

// Exporters write an L, which LuxRender's sun and sky do not read.
TEST(SunAndSky, TakeAnLThatChangesNothing) {
    for (const char* plugin : {"sun", "sky", "sunsky", "sky2", "sunsky2"}) {
        RecordedDiagnostics diagnostics;
        const Lights with =
            make(plugin, {sundir(0, 0.6, 0.8), numbers("color", "L", {3, 0, 0})}, diagnostics);
        EXPECT_EQ(diagnostics.warnings,
                  std::vector<std::string>{std::string(plugin) + ": \"L\" has no effect here"});
        const Lights without = make(plugin, {sundir(0, 0.6, 0.8)}, diagnostics);
        for (std::size_t i = 0; i < with.size(); ++i)
            EXPECT_EQ(with[i]->power(), without[i]->power()) << plugin;
    }
}

TEST(SunAndSky, ShareTheirParametersAndTransform) {
    RecordedDiagnostics diagnostics;
    Matrix tilted;
    tilted.setAxisAngle(Imath::V3d(1, 0, 0), kPi / 2);  // +z to -y
    const Lights lights = make("sunsky", {sundir(0, 0, 1)}, diagnostics, tilted);
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0]->kind(), "sun");
    EXPECT_EQ(lights[1]->kind(), "sky");
    EXPECT_FALSE(is_black(lights[0]->escaped(Vec3(0, -1, 0))));
    EXPECT_TRUE(is_black(lights[0]->escaped(Vec3(0, 0, 1))));
    EXPECT_TRUE(diagnostics.warnings.empty());
    EXPECT_EQ(make("sunsky2", {sundir(0, 0, 1)}, diagnostics).size(), 2u);
    EXPECT_TRUE(diagnostics.warnings.empty());
}

}  // namespace
}  // namespace lxs::test::sun_and_sky_test
