// Protects where photons of lights at infinity start: close to the box around all surfaces, so that
// rays of single precision come to a view of millimetres on a ground of kilometres everywhere, and
// not on a lattice; and that those which pass the box by, and no others, are not shot.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "light_cases.h"

namespace lxs::test::photon_start_test {
namespace {

using Imath::V3d;

/// A box of 20 km x 20 km that is `height` high.
SceneSphere wide_scene(float height) {
    const Bounds box(Vec3(-1e4f, -1e4f, 0), Vec3(1e4f, 1e4f, height));
    return {box.center(), (box.max - box.min).length() / 2 * 1.00001f, box};
}

std::unique_ptr<Light> light_above(const SceneSphere& sphere, const std::string& name,
                                   const Vec3& from) {
    LightDescription description;
    const auto vector = [](const std::string& parameter, const Vec3& v) {
        return numbers("vector", parameter, {v.x, v.y, v.z});
    };
    description.parameters = {name, {}, {vector("sundir", from)}};
    if (name == "distant") {
        description.parameters.values = {numbers("point", "from", {from.x, from.y, from.z}),
                                         numbers("point", "to", {0, 0, 0})};
    }
    RecordedDiagnostics diagnostics;
    auto lights = make_lights(
        description, sphere, [](const std::string& asset, const SourceLocation&) { return asset; },
        diagnostics);
    return std::move(lights.front());
}

/// Coordinates of the photon that comes to `p`.
PrimaryPoint coordinates_of(const Light& light, const Vec3& p) {
    PrimaryPoint u{0.5, 0.5, 0.3, 0.6};
    DirectSample sample;
    EXPECT_TRUE(light.sample_direct(p, Vec3(0, 0, 1), Vec2(0.3f, 0.6f), sample));
    EXPECT_TRUE(light.emission_coordinates(p, sample, u));
    return u;
}

/// Where the photon comes to the plane z = 0.
V3d at_ground(const Light& light, const PrimaryPoint& u) {
    EmissionSample photon;
    EXPECT_TRUE(light.sample_emission(u, photon));
    const V3d o(photon.ray.origin), d(photon.ray.direction);
    return o - d * (o.z / d.z);
}

/// Of the steps of 2^-24, which are 1.7 mm on this ground, what a photon's place is off by.
double worst_miss(const Light& light, const Vec3& view) {
    const PrimaryPoint at_view = coordinates_of(light, view);
    Random random(17);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        PrimaryPoint u = at_view;
        for (const int axis : {0, 1})
            u[axis] += 8 * 0x1p-24 * (double(random()) - 0.5);
        const PrimaryPoint back = coordinates_of(light, Vec3(at_ground(light, u)));
        for (const int axis : {0, 1})
            worst = std::max(worst, std::abs(back[axis] - u[axis]) * 0x1p24);
    }
    return worst;
}

TEST(PhotonStart, ParallelLightFallsEverywhereOnANarrowView) {
    for (const Vec3& from : {Vec3(0.3f, 0.2f, 1), Vec3(1, 0, 1), Vec3(0, 0, 1)}) {
        SCOPED_TRACE(from);
        for (const Vec3& view : {Vec3(0.0f), Vec3(3.1f, -2.7f, 0)}) {
            EXPECT_LT(worst_miss(*light_above(wide_scene(0.05f), "distant", from), view), 0.01);
            // From a kilometre above the view, where origins are 0.06 mm apart.
            EXPECT_LT(worst_miss(*light_above(wide_scene(1000), "distant", from), view), 0.1);
        }
    }
}

/// Whether the ray meets the box grown by a length.
bool meets(const Ray& ray, const SceneSphere& sphere, double grown) {
    double from = -1e30, to = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = double(ray.origin[axis]), d = double(ray.direction[axis]);
        const double a = (double(sphere.surfaces.min[axis]) - grown - o) / d;
        const double b = (double(sphere.surfaces.max[axis]) + grown - o) / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to && to > 0;
}

/// The power of the photons shot is that of the light which falls on the box, and all of them begin
/// before it. Its silhouette is the sum of its faces', seen from the light.
TEST(PhotonStart, AsMuchLightAsFallsOnTheBoxIsShot) {
    for (const float height : {0.05f, 1000.0f, 20000.0f}) {
        const SceneSphere sphere = wide_scene(height);
        for (const std::string name : {"distant", "sun"}) {
            SCOPED_TRACE(name + " over " + std::to_string(height) + " m");
            const Vec3 wi = Vec3(0.5f, 0.2f, 0.4f).normalized();
            const auto light = light_above(sphere, name, wi);
            Random random(19);
            constexpr int kPhotons = 100000;
            int shot = 0;
            for (int i = 0; i < kPhotons; ++i) {
                EmissionSample photon;
                if (!light->sample_emission({random(), random(), random(), random()}, photon))
                    continue;
                ++shot;
                ASSERT_TRUE(meets(photon.ray, sphere, 1e-4 * double(sphere.radius)));
                ASSERT_FALSE(sphere.surfaces.intersects(photon.ray.origin));
            }
            const Vec3 size = sphere.surfaces.size();
            const double silhouette = double(size.x) * double(size.y) * double(wi.z) +
                                      double(size.y) * double(size.z) * double(wi.x) +
                                      double(size.z) * double(size.x) * double(wi.y);
            const double share =
                silhouette / (std::numbers::pi * double(sphere.radius) * double(sphere.radius));
            // Four standard errors (p < 1e-4); the box is grown by a ten-thousandth.
            EXPECT_NEAR(shot / double(kPhotons), share,
                        4 * std::sqrt(share * (1 - share) / kPhotons) + 5e-4);
        }
    }
}

}  // namespace
}  // namespace lxs::test::photon_start_test
