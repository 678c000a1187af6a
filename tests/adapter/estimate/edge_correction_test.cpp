// Protects the correction of edges: photons count by the part of their gather disc that is surface,
// in the mean, and by nothing else where all of it is.
#include "estimate/edge_correction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimate/constants.h"
#include "render_mock.h"

namespace aips::edge_correction_test {
namespace {

constexpr float kRadius = 0.1f;

mock::Scene finished(mock::Scene scene) {
    scene.finish();
    return scene;
}

/// The floor z = 0 with x < 1, and the wall x = 1 below it.
mock::Scene step() {
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    scene.add(surface);
    surface.shape = mock::Quad{{1, -1, -1}, {0, 2, 0}, {0, 0, 1}};
    scene.add(surface);
    return finished(std::move(scene));
}

VisiblePoint point_at(Vec3 position) {
    VisiblePoint point;
    point.position = position;
    point.geometric_normal = point.shading_normal = point.wo = {0, 0, 1};
    return point;
}

/// Share of a disc on one side of a line at `distance` (radii) from its centre, the greater one.
double share_beside(double distance) {
    return 1 -
           (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / std::numbers::pi;
}

double expected_missing(double share) {
    return (1 - share) * (1 - std::pow(1 - share, double(kMostTrials))) / share;
}

struct Moments {
    double mean = 0, error = 0;
};

Moments missing_at(const mock::Scene& scene, const VisiblePoint& point,
                   const SurfaceQuestion& question) {
    constexpr int kDraws = 20000;
    Arena arena;
    SurfaceShare surface(scene, 0, arena);
    double sum = 0, squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        RandomStream random(5, 0, std::uint64_t(i), RandomDomain::Edge);
        const double missing = double(surface.missing(point, kRadius, question, random));
        sum += missing;
        squares += missing * missing;
    }
    const double mean = sum / kDraws;
    return {mean, std::sqrt((squares / kDraws - mean * mean) / kDraws)};
}

/// At five standard errors: one seed in a million fails of each.
TEST(EdgeCorrection, MakesUpForWhatTheDiscLacksInTheMean) {
    const mock::Scene scene = step();
    for (const float distance : {0.0f, 0.3f, 0.8f}) {
        const VisiblePoint point = point_at({1 - distance * kRadius, 0, 0});
        const double share = share_beside(double(distance));
        for (const std::uint32_t side : {1u, 2u, 3u}) {
            const Moments all = missing_at(scene, point, {side, 0});
            EXPECT_NEAR(all.mean, expected_missing(share), 5 * all.error) << distance;
            const Moments some = missing_at(scene, point, {side, 0.5f});
            EXPECT_NEAR(some.mean, expected_missing(0.5 + 0.5 * share), 5 * some.error);
        }
    }
}

/// What the factor brings too little: at five standard errors.
TEST(EdgeCorrection, LosesWhatTheFactorDoesNotMakeUpFor) {
    const mock::Scene scene = step();
    constexpr int kDraws = 20000;
    for (const float distance : {0.0f, 0.8f, -0.8f}) {
        const VisiblePoint point = point_at({1 - distance * kRadius, 0, 0});
        const double share =
            distance < 0 ? 1 - share_beside(-double(distance)) : share_beside(double(distance));
        for (const float believed : {0.0f, 0.5f, 1.0f}) {
            Arena arena;
            SurfaceShare surface(scene, 0, arena);
            int lost = 0;
            for (int i = 0; i < kDraws; ++i) {
                RandomStream random(6, 0, std::uint64_t(i), RandomDomain::Edge);
                lost += surface.loses(point, kRadius, {2, believed}, random);
            }
            const double passes = double(believed) + (1 - double(believed)) * share;
            const double expected = 1 - share * (1 + expected_missing(passes));
            const double error = std::sqrt(expected * (1 - expected) / kDraws);
            EXPECT_NEAR(double(lost) / kDraws, expected, 5 * error) << distance << ' ' << believed;
        }
    }
}

TEST(EdgeCorrection, AGridOfPlacesHasLessNoise) {
    const VisiblePoint point = point_at({1, 0, 0});
    const mock::Scene scene = step();
    EXPECT_LT(missing_at(scene, point, {2, 0}).error, 0.5 * missing_at(scene, point, {1, 0}).error);
}

TEST(EdgeCorrection, LeavesWholeDiscsAlone) {
    const mock::Scene floor = step();
    EXPECT_EQ(missing_at(floor, point_at({1 - 1.01f * kRadius, 0, 0}), {2, 0}).mean, 0);
    // Curved away within the slab, as photons are gathered there.
    mock::Scene scene;
    mock::Surface ball;
    ball.shape = mock::Ball{{0, 0, -2 * kRadius}, 2 * kRadius, false};
    scene.add(ball);
    EXPECT_EQ(missing_at(finished(std::move(scene)), point_at({}), {2, 0}).mean, 0);
}

/// Glass on the floor beside the point: light comes through it, the floor is there.
TEST(EdgeCorrection, WhatStandsOnASurfaceHidesNoneOfIt) {
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    scene.add(surface);
    surface.shape = mock::Quad{{0.02f, -1, 0}, {0, 2, 0}, {0, 0, 1}};
    scene.add(surface);
    EXPECT_EQ(missing_at(finished(std::move(scene)), point_at({}), {2, 0}).mean, 0);
}

/// The first surface below is then the ball's, which the floor's points are separated from by
/// itself.
TEST(EdgeCorrection, TheFloorUnderABallOfGlassIsThere) {
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    scene.add(surface);
    surface.shape = mock::Ball{{0, 0, 0.31f}, 0.3f, false};
    scene.add(surface);
    const SurfaceQuestion reached{.side = 2, .occlusion = 1};
    const mock::Scene all = finished(std::move(scene));
    for (const float x : {0.0f, 0.03f, 0.1f})
        EXPECT_EQ(missing_at(all, point_at({x, 0, 0}), reached).mean, 0) << x;
}

/// A closed box of albedo 1/2 that emits 1 everywhere shows 2 everywhere, in its edges too.
double seen_in_edges(bool correct, double start_radius) {
    mock::Scene scene;
    mock::Surface wall;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    constexpr std::uint32_t kSize = 32;
    Settings settings = mock::small_settings(31, 20000);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 16;
    settings.start_radius = start_radius;
    if (start_radius == 0) settings.radius = RadiusKind::Adaptive;
    settings.correct_edges = correct;
    const auto camera = mock::camera_along_y({0, -0.5f, 0}, 1.1f, kSize, kSize);
    return mock::render(scene, camera, kSize, kSize, settings, 60).film.mean();
}

TEST(EdgeCorrection, EdgesOfAFurnaceAreAsBrightAsItsWalls) {
    EXPECT_NEAR(seen_in_edges(true, 2), 2, 0.02);
    EXPECT_LT(seen_in_edges(false, 2), 1.95);
    // Adaptive radii shrink at edges by themselves.
    EXPECT_NEAR(seen_in_edges(true, 0), 2, 0.02);
    EXPECT_LT(seen_in_edges(false, 0), 1.97);
}

}  // namespace
}  // namespace aips::edge_correction_test
