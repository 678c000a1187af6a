// Faults of a host's surfaces and facts: each is planted in a sound scene and found alone.
#include <gtest/gtest.h>

#include "faulty_scene.h"

namespace aips::scene_faults_test {
namespace {

mock::Scene room() {
    return mock::lamp_box({}, mock::half_mirror());
}

/// The only finding is of the scene as a whole.
void expect_scene_fault(const mock::Spoils& spoils, const std::string& check) {
    const mock::Scene scene = room();
    const auto findings = validate_host(mock::FaultyScene(scene, spoils), mock::quick_check());
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].subject, "scene");
    EXPECT_EQ(findings[0].check, check) << mock::lines(findings);
}

TEST(SceneFaults, MaxBsdfBytesTooSmall) {
    mock::Spoils spoils;
    spoils.facts = [](SceneFacts& facts) { facts.max_bsdf_bytes = 48; };
    expect_scene_fault(spoils, "memory");
}

TEST(SceneFaults, FactsLackALobe) {
    mock::Spoils spoils;
    spoils.facts = [](SceneFacts& facts) { facts.lobes = kDiffuse; };
    expect_scene_fault(spoils, "lobes");
}

TEST(SceneFaults, NormalsThatAreNotUnit) {
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) {
        point.geometric_normal = point.geometric_normal * 1.1f;
    };
    expect_scene_fault(spoils, "normals");
}

TEST(SceneFaults, ShadingNormalsOnTheOtherSide) {
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) {
        point.geometric_normal = -point.geometric_normal;
    };
    expect_scene_fault(spoils, "shading normal");
}

TEST(SceneFaults, PositionsBesideTheRay) {
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) { point.distance *= 0.9f; };
    expect_scene_fault(spoils, "position");
}

TEST(SceneFaults, SurfacesBeyondTheBounds) {
    mock::Spoils spoils;
    spoils.bounds.emplace();
    spoils.bounds->extend(Vec3{-0.5f, -0.5f, -0.5f});
    spoils.bounds->extend(Vec3{0.5f, 0.5f, 0.5f});
    expect_scene_fault(spoils, "bounds");
}

TEST(SceneFaults, RaysThatMeetWhatTheyLeave) {
    mock::Spoils spoils;
    // Below the surface by more than the mock's own smallest step.
    spoils.spawned = [](Ray& ray) { ray.origin = ray.origin - ray.direction * 6e-5f; };
    expect_scene_fault(spoils, "spawn");
}

TEST(SceneFaults, ValuesThatAreNotFinite) {
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) {
        if (point.material == 2) point.transmittance.g = std::numeric_limits<float>::quiet_NaN();
    };
    expect_scene_fault(spoils, "values");
}

TEST(SceneFaults, LightsThatAreNotThere) {
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) {
        if (point.material == 2) point.light = 7;
    };
    expect_scene_fault(spoils, "indices");
}

}  // namespace
}  // namespace aips::scene_faults_test
