// The ready scene: its triangles are where they ought to be, and it is a sound host.
#include "aips/parts/triangle_scene.h"

#include <gtest/gtest.h>

#include "aips/adapter/host_validation.h"
#include "aips/core/base/arena.h"
#include "aips/core/sampling/sampling.h"
#include "render_mock.h"

namespace aips::triangle_scene_test {
namespace {

/// mock::lamp_box(), without its ball.
void build_box(TriangleScene& scene) {
    const auto wall = scene.add_material({.name = "wall"});
    const auto lamp =
        scene.add_material({.reflectance = {0, 0, 0}, .emitted = {10, 10, 10}, .name = "lamp"});
    scene.add_room({-1, -1, -1}, {1, 1, 1}, wall);
    scene.add_quad({-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}, lamp);
    scene.finish();
}

mock::Scene mock_box() {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    scene.finish();
    return scene;
}

TEST(TriangleScene, MeetsWhatAnotherHostMeets) {
    TriangleScene scene;
    build_box(scene);
    const mock::Scene other = mock_box();
    RandomStream random(3, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 origin{random.next() - 0.5f, random.next() - 0.5f, random.next() - 0.5f};
        const Ray ray{origin, square_to_uniform_sphere(random.next2())};
        Arena arena;
        SurfacePoint met, expected;
        ASSERT_TRUE(scene.intersect(ray, met, arena) && other.intersect(ray, expected, arena));
        ASSERT_NEAR(met.distance, expected.distance, 1e-5f);
        ASSERT_LT(length(met.geometric_normal - expected.geometric_normal), 1e-5f);
        ASSERT_EQ(met.emitted, expected.emitted);
    }
}

TEST(TriangleScene, ABallIsRound) {
    TriangleScene scene;
    scene.add_ball({1, 2, 3}, 2, 64, scene.add_material({}));
    scene.finish();
    RandomStream random(4, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 d = square_to_uniform_sphere(random.next2());
        Arena arena;
        SurfacePoint met;
        ASSERT_TRUE(scene.intersect({Vec3{1, 2, 3} + d * 5, -d}, met, arena));
        ASSERT_NEAR(met.distance, 3, 0.01f);
        ASSERT_GT(dot(met.geometric_normal, d), 0.99f) << "front outside";
        ASSERT_GT(dot(met.shading_normal, d), 0.99999f);
    }
}

TEST(TriangleScene, IsASoundHost) {
    using Kind = TriangleMaterial::Kind;
    TriangleScene scene;
    const auto wall = scene.add_material({.reflectance = {0.5f, 0.7f, 0.3f}, .name = "wall"});
    const auto glass = scene.add_material({.kind = Kind::Glass, .name = "glass"});
    const auto mirror = scene.add_material(
        {.kind = Kind::Mirror, .reflectance = {0.9f, 0.8f, 1}, .name = "mirror"});
    const auto lamp = scene.add_material({.emitted = {3, 2, 1}, .light_group = 1, .name = "lamp"});
    scene.add_room({-1, -1, -1}, {1, 1, 1}, wall);
    scene.add_ball({0.4f, 0.3f, -0.5f}, 0.4f, 24, glass);
    scene.add_ball({-0.5f, 0, -0.5f}, 0.3f, 24, mirror);
    scene.add_quad({-0.3f, -0.3f, 0.9f}, {0, 0.6f, 0}, {0.6f, 0, 0}, lamp);
    scene.add_point_light({0.7f, -0.7f, 0.5f}, {1, 1, 1});
    scene.finish();
    EXPECT_EQ(scene.light_groups(), 2u);
    for (const HostFinding& finding : validate_host(scene))
        ADD_FAILURE() << to_string(finding);
}

/// Rays from a thousand scene sizes away end on the surface, not below it: else light is lost.
TEST(TriangleScene, IsLitAlsoWhereSeenFromAfar) {
    TriangleScene scene;
    const auto floor = scene.add_material({});
    scene.add_quad({-1, -1, 0}, {2, 0, 0.3f}, {0, 2, 0.2f}, floor);
    scene.finish();
    RandomStream random(5, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 target{random.next() - 0.5f, random.next() - 0.5f, 0.25f};
        Vec3 away = square_to_uniform_sphere(random.next2());
        away.z = std::abs(away.z) + 0.5f;
        const Vec3 origin = target + normalize(away) * 1000;
        Arena arena;
        SurfacePoint met;
        ASSERT_TRUE(scene.intersect({origin, normalize(target - origin)}, met, arena));
        DirectSample sample;
        sample.wi = normalize(Vec3{0, 0, 3} - met.position);
        sample.distance = length(Vec3{0, 0, 3} - met.position);
        ASSERT_EQ(scene.visibility(met, sample, 0), kWhite) << i;
    }
}

/// The triangles' boxes are flat: rays within them meet what stands across, from either side.
TEST(TriangleScene, RaysWithinFacesOfBoxesMeetWhatIsThere) {
    TriangleScene scene;
    const auto wall = scene.add_material({});
    scene.add_triangle({{2, -1, 0}, {2, 1, 0}, {2, 0, 1}}, wall);
    scene.finish();
    for (const float zero : {0.0f, -0.0f}) {
        for (const Vec3 origin : {Vec3{0, 0, 0}, Vec3{0, 0, 1}}) {
            Arena arena;
            SurfacePoint met;
            EXPECT_TRUE(scene.intersect({origin, {1, zero, zero}}, met, arena)) << origin.z << zero;
        }
        for (const Vec3 origin : {Vec3{0, 0, -0.01f}, Vec3{0, 0, 1.01f}}) {
            Arena arena;
            SurfacePoint met;
            EXPECT_FALSE(scene.intersect({origin, {1, zero, zero}}, met, arena));
        }
    }
}

/// Far from the origin coordinates are coarse; photons still start before their tilted lamp.
TEST(TriangleScene, IsASoundHostFarFromTheOrigin) {
    const Vec3 at{1000, 1000, 1000};
    TriangleScene scene;
    const auto wall = scene.add_material({.name = "wall"});
    const auto lamp = scene.add_material({.emitted = {3, 2, 1}, .name = "lamp"});
    scene.add_room(at - Vec3{1, 1, 1}, at + Vec3{1, 1, 1}, wall);
    scene.add_quad(at + Vec3{-0.3f, -0.3f, 0.8f}, {0.1f, 0.6f, 0.13f}, {0.6f, -0.1f, 0.07f}, lamp);
    scene.finish();
    for (const HostFinding& finding : validate_host(scene))
        ADD_FAILURE() << to_string(finding);
}

/// Mean luminances of eight renders of each by different seeds: a t-test.
TEST(TriangleScene, GivesTheImageOfAnotherHost) {
    TriangleScene triangles;
    build_box(triangles);
    const mock::Scene quads = mock_box();
    double sum = 0, squares = 0;
    constexpr int kSeeds = 8;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const auto mean = [&](const Scene& scene, std::uint64_t offset) {
            const auto settings = mock::small_settings(2 * std::uint64_t(seed) + offset, 20000);
            const mock::Camera camera =
                mock::camera_along_y({0, -0.9f, 0}, 0.5f, 16, 16);  // the lamp is out of view
            return mock::render(scene, camera, 16, 16, settings, 4).film.mean();
        };
        const double difference = mean(triangles, 0) / mean(quads, 1) - 1;
        sum += difference;
        squares += difference * difference;
    }
    const double mean = sum / kSeeds;
    const double error = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
    EXPECT_LT(error, 0.01);
    EXPECT_LT(std::abs(mean), 5.4 * error) << "t of 7 degrees of freedom: p = 0.001";
}

}  // namespace
}  // namespace aips::triangle_scene_test
