// Protects what separates photons from visible points: walls and sheets thinner than the radius do,
// whatever their thickness; a surface that bends away from itself does not.
#include "estimate/photon_occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render_mock.h"

namespace aips::photon_occlusion_test {
namespace {

constexpr float kRadius = 0.1f;
constexpr Vec3 kUp{0, 0, 1};

mock::Surface quad(Vec3 corner, Vec3 u, Vec3 v) {
    mock::Surface surface;
    surface.shape = mock::Quad{corner, u, v};
    return surface;
}

VisiblePoint point_at(Vec3 position, Vec3 normal = kUp) {
    VisiblePoint point;
    point.position = position;
    point.geometric_normal = point.shading_normal = point.wo = normal;
    return point;
}

bool separated_at(const mock::Scene& scene, Vec3 from, Vec3 to, Vec3 normal_from = kUp,
                  Vec3 normal_to = kUp) {
    return separated(scene, point_at(from, normal_from), to, normal_to, kRadius, 0);
}

/// A floor, and on it the wall 0 <= x <= thickness; one plane if that is 0.
mock::Scene walled_floor(float thickness) {
    mock::Scene scene;
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    scene.add(quad({0, -1, 0}, {0, 2, 0}, {0, 0, 1}));
    if (thickness > 0) scene.add(quad({thickness, -1, 0}, {0, 0, 1}, {0, 2, 0}));
    scene.finish();
    return scene;
}

TEST(PhotonOcclusion, AWallSeparatesTheFloorsBesideIt) {
    for (const float thickness : {0.0f, 0.001f, 0.02f}) {
        const mock::Scene scene = walled_floor(thickness);
        EXPECT_TRUE(separated_at(scene, {-0.03f, 0, 0}, {0.05f, 0.02f, 0})) << thickness;
        EXPECT_TRUE(separated_at(scene, {0.05f, 0, 0}, {-0.001f, 0, 0})) << thickness;
        EXPECT_FALSE(separated_at(scene, {-0.03f, 0, 0}, {-0.09f, 0.05f, 0})) << thickness;
    }
}

/// Sheets whose distance is a twentieth of the radius: light above the upper one does not count on
/// the lower one, from either side.
TEST(PhotonOcclusion, ParallelSheetsSeparateEachOther) {
    mock::Scene scene;
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    scene.add(quad({-1, -1, -0.005f}, {2, 0, 0}, {0, 2, 0}));
    scene.finish();
    const Vec3 upper{0, 0, 0}, lower{0.04f, 0.02f, -0.005f};
    EXPECT_TRUE(separated_at(scene, upper, lower));
    EXPECT_TRUE(separated_at(scene, lower, upper));
    EXPECT_TRUE(separated_at(scene, upper, lower, kUp, -kUp)) << "light from below";
    EXPECT_FALSE(separated_at(scene, upper, {0.04f, 0.02f, 0}));
}

/// Bent away from the light, sharply at an edge or as a ball: the straight way would lie inside.
TEST(PhotonOcclusion, ASurfaceThatBendsAwayDoesNotSeparateItself) {
    mock::Scene roof;
    roof.add(quad({-1, -1, -0.7f}, {1, 0, 0.7f}, {0, 2, 0}));
    roof.add(quad({0, -1, 0}, {1, 0, -0.15f}, {0, 2, 0}));
    roof.finish();
    const Vec3 left = normalize(Vec3{-0.7f, 0, 1}), right = normalize(Vec3{0.15f, 0, 1});
    for (const float a : {0.001f, 0.01f, 0.05f}) {
        for (const float b : {0.002f, 0.02f, 0.07f}) {
            EXPECT_FALSE(
                separated_at(roof, {-a, 0, -0.7f * a}, {b, 0.01f, -0.15f * b}, left, right))
                << a << ' ' << b;
        }
    }
    mock::Scene scene;
    mock::Surface ball;
    ball.shape = mock::Ball{{}, 0.1f, false};
    scene.add(ball);
    scene.finish();
    for (int i = 1; i < 20; ++i) {
        const float angle = 0.04f * float(i);
        const Vec3 n{std::sin(angle), 0, std::cos(angle)};
        EXPECT_FALSE(separated_at(scene, {0, 0, 0.1f}, n * 0.1f, kUp, n)) << angle;
    }
}

/// A small lamp in the near room, and one 400 times as bright in the far one behind a wall.
mock::Scene two_rooms(float thickness, bool far_lamp) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.reflectance = {0.5f, 0.5f, 0.5f};
    scene.add_box({-1, -1, 0}, {1, 1, 1}, wall);
    scene.add(quad({0, -1, 0}, {0, 2, 0}, {0, 0, 1}));
    if (thickness > 0) scene.add(quad({thickness, -1, 0}, {0, 0, 1}, {0, 2, 0}));
    mock::Surface lamp = quad({-0.6f, -0.1f, 0.99f}, {0, 0.2f, 0}, {0.2f, 0, 0});
    lamp.emitted = {1, 1, 1};
    scene.add(lamp);
    if (far_lamp) {
        lamp = quad({0.4f, -0.1f, 0.99f}, {0, 0.2f, 0}, {0.2f, 0, 0});
        lamp.emitted = {100, 100, 100};
        scene.add(lamp);
    }
    scene.finish();
    return scene;
}

/// By plain photons within a radius of four pixels, so that the wall is all that is in question.
double seen_of_near_room(float thickness, bool far_lamp, bool occlusion, std::uint64_t seed) {
    const mock::Scene scene = two_rooms(thickness, far_lamp);
    Settings settings = mock::small_settings(seed, far_lamp ? 40000 : 400);
    settings.continue_eye_paths = false;
    settings.start_radius = 4;
    settings.photon_occlusion = occlusion;
    constexpr std::uint32_t kSize = 16;
    const auto camera = mock::camera_along_y({-0.5f, -0.9f, 0.5f}, 0.6f, kSize, kSize);
    return mock::render(scene, camera, kSize, kSize, settings, 16).film.mean();
}

/// At most 1.02 of the right mean after 16 passes; without the rays 1.4 times as much.
TEST(PhotonOcclusion, LightOfTheNextRoomDoesNotCount) {
    for (const float thickness : {0.0f, 0.01f}) {
        double right = 0, seen = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            right += seen_of_near_room(thickness, false, false, seed) / 4;
            seen += seen_of_near_room(thickness, true, true, seed) / 4;
        }
        EXPECT_NEAR(seen / right, 1, 0.02) << thickness;
        EXPECT_GT(seen_of_near_room(thickness, true, false, 1), 1.2 * right) << thickness;
    }
}

/// A lamp inside a closed ball smaller than the radius, seen from outside: photons on the far wall
/// face the way of the near one. With every engine that has photons, the published ones if they are
/// asked to.
TEST(PhotonOcclusion, LightStaysInsideAClosedBall) {
    mock::Scene scene;
    mock::Surface ball;
    ball.shape = mock::Ball{{0, 2, 0}, 0.1f, false};
    scene.add(ball);
    scene.add_point_light({0, 2, 0}, {1, 1, 1});
    scene.finish();
    const auto mean = [&](Mode mode, GuideKind guide, bool occlusion) {
        Settings settings = mock::small_settings(3, 20000);
        settings.mode = mode;
        settings.guide = guide;
        settings.continue_eye_paths = settings.correct_edges = false;
        settings.photon_occlusion = occlusion;
        settings.start_radius = 16;  // several balls wide
        const auto camera = mock::camera_along_y({0, 0, 0}, 0.2f, 24, 16);
        return mock::render(scene, camera, 24, 16, settings, 3).film.mean();
    };
    EXPECT_GT(mean(Mode::Progressive, GuideKind::None, false), 0) << "nothing leaks";
    for (const Mode mode : {Mode::Progressive, Mode::PhotonMap, Mode::Ppm}) {
        for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive})
            EXPECT_EQ(mean(mode, guide, true), 0) << int(mode) << ", guide " << mock::name(guide);
    }
}

}  // namespace
}  // namespace aips::photon_occlusion_test
