// Protects Light::emission_coordinates of the mock host, on which the tests of eye seeding rest: a
// photon emitted from them goes from the sampled light point through the lit point.
#include <gtest/gtest.h>

#include "aips/core/sampling/random.h"
#include "mock_lights.h"

namespace aips::emission_coordinates_test {
namespace {

float distance_to_ray(Vec3 p, const Ray& ray) {
    const Vec3 to = p - ray.origin;
    return length(to - ray.direction * std::max(0.0f, dot(to, ray.direction)));
}

/// The photon emitted at `u` goes from the sampled light point through `at`.
void expect_photon(const Light& light, const SurfacePoint& at, const DirectSample& sample,
                   const PrimaryPoint& u) {
    for (const double x : u)
        ASSERT_TRUE(x >= 0 && x < 1) << x;
    Emission emission;
    ASSERT_TRUE(light.emit(u, emission));
    // In units of the scene, which is a few wide; grazing directions are the least exact.
    ASSERT_LT(distance_to_ray(at.position, emission.ray), 2e-3f);
    ASSERT_LT(length(emission.ray.direction + sample.wi), 2e-3f);
    if (light.at_infinity()) return;
    const Vec3 light_point = at.position + sample.wi * sample.distance;
    ASSERT_LT(length(emission.ray.origin - light_point), 1e-3f);
}

/// Points in the unit cube around the origin.
void check(const Light& light) {
    RandomStream random(73, 0, 0, RandomDomain::Guide);
    int lit = 0, found = 0;
    for (int i = 0; i < 20000; ++i) {
        SurfacePoint at;
        at.position = {random.next() - 0.5f, random.next() - 0.5f, random.next() - 0.5f};
        DirectSample sample;
        if (!light.sample_direct(at, random.next2(), sample)) continue;
        ++lit;
        PrimaryPoint u{};
        if (!light.emission_coordinates(at, sample, u)) continue;
        ++found;
        ASSERT_NO_FATAL_FAILURE(expect_photon(light, at, sample, u)) << i;
    }
    EXPECT_GT(lit, 5000);
    EXPECT_GE(found, 0.998 * lit);  // rounding may put a direction beyond a cone's rim
}

TEST(MockEmissionCoordinates, Quad) {
    check(*mock::make_quad_light({{-1, -1, 0.2f}, {0.3f, 2, 0}, {2, 0, 0.2f}}, kWhite, 0));
}
TEST(MockEmissionCoordinates, Ball) {
    check(*mock::make_ball_light({{0, 0, 1}, 0.4f, false}, kWhite, 0));
}
TEST(MockEmissionCoordinates, BallFromInside) {
    check(*mock::make_ball_light({{0, 0, 0.2f}, 2, true}, kWhite, 0));
}
TEST(MockEmissionCoordinates, Point) {
    check(*mock::make_point_light({0.6f, 0.7f, 0.8f}, kWhite));
}

Bounds cube() {
    Bounds bounds;
    bounds.extend(Vec3{-0.5f, -0.5f, -0.5f});
    bounds.extend(Vec3{0.5f, 0.5f, 0.5f});
    return bounds;
}
TEST(MockEmissionCoordinates, Environment) {
    check(*mock::make_distant_light(cube(), {}, kWhite));
}
TEST(MockEmissionCoordinates, Sun) {
    const mock::DistantCone cone{normalize({1, 2, 3}), 0.999f};
    check(*mock::make_distant_light(cube(), cone, kWhite));
}

TEST(MockEmissionCoordinates, NoneWhereNoLightArrives) {
    PrimaryPoint u{};
    SurfacePoint at;
    DirectSample sample;
    const auto quad = mock::make_quad_light({{-1, -1, 1}, {0, 2, 0}, {2, 0, 0}}, kWhite, 0);
    ASSERT_TRUE(quad->sample_direct(at, {0.3f, 0.6f}, sample));
    EXPECT_TRUE(quad->emission_coordinates(at, sample, u));
    sample.wi = -sample.wi;
    at.position.z = 2;
    EXPECT_FALSE(quad->emission_coordinates(at, sample, u)) << "behind";
    const auto sun = mock::make_distant_light(cube(), {{0, 0, 1}, 0.999f}, kWhite);
    at.position = {};
    ASSERT_TRUE(sun->sample_direct(at, {0.3f, 0.6f}, sample));
    EXPECT_TRUE(sun->emission_coordinates(at, sample, u));
    at.position = {3, 0, 0};
    EXPECT_FALSE(sun->emission_coordinates(at, sample, u)) << "beyond the scene";
    sample.wi = {0, 1, 0};
    at.position = {};
    EXPECT_FALSE(sun->emission_coordinates(at, sample, u)) << "not in the sun";
}

}  // namespace
}  // namespace aips::emission_coordinates_test
