// No light gives NaN or infinity, whatever the random numbers and the point it lights.
#include <gtest/gtest.h>

#include <cmath>

#include "light_cases.h"
#include "lxs/sdk/warp.h"

namespace lxs::test::robustness_test {
namespace {

/// Rounded to single precision it is 1.
constexpr double kBelowOne = 1 - 0x1p-53;

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool sound(const Rgb& c) {
    return finite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0;
}

std::vector<std::unique_ptr<Light>> all_lights() {
    std::vector<std::unique_ptr<Light>> lights;
    for (ExtendedLight& c : extended_lights())
        lights.push_back(std::move(c.light));
    for (const char* plugin : {"point", "spot", "distant", "goniometric", "projection"})
        lights.push_back(make_one(plugin, {}));
    return lights;
}

void check_direct(const Light& light, const Vec3& p, const Vec2& u) {
    DirectSample s;
    if (!light.sample_direct(p, Vec3(0, 0, 1), u, s)) {
        EXPECT_EQ(s.pdf, 0);
        return;
    }
    EXPECT_TRUE(sound(s.radiance));
    EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf > 0);
    EXPECT_NEAR(s.wi.length(), 1, 1e-5);
    EXPECT_TRUE(s.distance > 0);
    EXPECT_TRUE(finite(s.segment_end));
}

void check_emission(const Light& light, const PrimaryPoint& u) {
    EmissionSample s;
    if (!light.sample_emission(u, s)) return;
    EXPECT_TRUE(sound(s.power));
    EXPECT_TRUE(finite(s.ray.origin));
    EXPECT_NEAR(s.ray.direction.length(), 1, 1e-5);
    EXPECT_GE(s.ray.direction ^ s.normal, -1e-6f);
}

TEST(LightRobustness, CornersOfTheUnitCube) {
    for (const auto& light : all_lights()) {
        SCOPED_TRACE(light->kind());
        EXPECT_TRUE(std::isfinite(light->power()) && light->power() > 0);
        for (int corner = 0; corner < 81; ++corner) {
            const auto value = [](int digit) {
                return digit == 0 ? 0.0 : (digit == 1 ? 0.5 : kBelowOne);
            };
            const PrimaryPoint u = {value(corner % 3), value(corner / 3 % 3), value(corner / 9 % 3),
                                    value(corner / 27)};
            check_emission(*light, u);
            check_direct(*light, Vec3(0.2f, 0.1f, 0),
                         Vec2(clamp_to_unit(float(u[0])), clamp_to_unit(float(u[1]))));
        }
    }
}

// A photon photon on the lamp itself asks the lamp for its direct light.
TEST(LightRobustness, PointsOnTheLight) {
    for (const auto& light : all_lights()) {
        SCOPED_TRACE(light->kind());
        Random random(47);
        for (int i = 0; i < 2000; ++i) {
            EmissionSample e;
            if (!light->sample_emission({random(), random(), random(), random()}, e)) continue;
            const Vec2 u(random(), random());
            check_direct(*light, e.ray.origin, u);
            const float pdf = light->pdf_direct(e.ray.origin, e.normal, -e.ray.direction,
                                                e.ray.origin, e.normal, 0);
            EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0);
        }
    }
}

TEST(LightRobustness, FarAndTinyLights) {
    const auto tiny = make_area_light(
        emissive(placed(Sphere{1e-6f, -1e-6f, 1e-6f, 360}, translation(1e3, 0, 0)), Rgb(1.0f)),
        Matrix());
    const auto huge = make_area_light(
        emissive(parallelogram(Vec3(-1e7f, -1e7f, 1e5f), Vec3(0, 2e7f, 0), Vec3(2e7f, 0, 0)),
                 Rgb(1.0f)),
        Matrix());
    Random random(53);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 u(random(), random());
        check_direct(*tiny, Vec3(0.0f), u);
        check_direct(*huge, Vec3(0.0f), u);
        check_emission(*tiny, {u.x, u.y, random(), random()});
        check_emission(*huge, {u.x, u.y, random(), random()});
    }
}

TEST(LightRobustness, PointAtTheLight) {
    const auto point = make_one("point", {});
    DirectSample s;
    EXPECT_FALSE(point->sample_direct(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.5f), s));
    EXPECT_EQ(s.pdf, 0);
    check_direct(*point, Vec3(1e-25f, 0, 0), Vec2(0.5f));
}

// Photons from infinity start outside of the scene and reach all of it.
TEST(LightRobustness, PhotonsFromInfinityCrossTheScene) {
    const SceneSphere sphere = scene_sphere();
    for (const char* plugin : {"infinite", "sky", "sun", "distant"}) {
        const auto light = make_one(plugin, {});
        Random random(59);
        double farthest = 0;
        for (int i = 0; i < 20000; ++i) {
            EmissionSample s;
            ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
            const Vec3 to_center = sphere.center - s.ray.origin;
            ASSERT_GT(to_center.length(), sphere.radius);
            const float along = to_center ^ s.ray.direction;
            ASSERT_GT(along, sphere.radius);
            const double off = (to_center - s.ray.direction * along).length();
            ASSERT_LE(off, sphere.radius * 1.0001);
            farthest = std::max(farthest, off);
        }
        EXPECT_GT(farthest, 0.99 * sphere.radius);
    }
}

}  // namespace
}  // namespace lxs::test::robustness_test
