// Protects the squared index ratio: it belongs to radiance (eye side) and not to photon power.
// Inside a closed dielectric everything is as if there were no boundary, and a diffuse room seen
// through a pane of it looks as bright as without.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::dielectric_test {
namespace {

/// A furnace (emission 1, albedo 0.5) around a solid glass ball; the camera is inside the ball or
/// outside of it. Radiance is n^2 * L inside, L outside: 2 for the infinite sum. A core within the
/// ball emits n^2, so that it stays so.
mock::Scene furnace_with_ball(float index, float core_radius = 0) {
    mock::Scene scene;
    mock::Surface wall;
    wall.emitted = {1, 1, 1};
    scene.add_box({-2, -2, -2}, {2, 2, 2}, wall);
    mock::Surface ball;
    ball.shape = mock::Ball{{0, 0, 0}, 1, false};
    ball.material.kind = mock::Material::Kind::Glass;
    ball.material.index = index;
    scene.add(ball);
    if (core_radius > 0) {
        mock::Surface core;
        core.shape = mock::Ball{{0, 0, 0}, core_radius, false};
        core.emitted = Rgb{1, 1, 1} * (index * index);
        scene.add(core);
    }
    scene.finish();
    return scene;
}

double seen_from(Vec3 eye, float index, float half) {
    constexpr std::uint32_t kSize = 24;
    const mock::Scene scene = furnace_with_ball(index);
    Settings settings = mock::small_settings(21, 40000);
    settings.max_eye_depth = 64;
    settings.max_photon_depth = 32;
    settings.start_radius = 3;
    const auto camera = mock::camera_along_y(eye, half, kSize, kSize);
    return mock::render(scene, camera, kSize, kSize, settings, 24).film.mean();
}

TEST(Dielectric, CameraInsideSeesSquaredIndexTimesRadiance) {
    EXPECT_NEAR(seen_from({0, 0, 0}, 1.5f, 0.3f), 1.5 * 1.5 * 2, 0.01 * 4.5);
}

TEST(Dielectric, BallInAFurnaceIsInvisible) {
    EXPECT_NEAR(seen_from({0, -1.9f, 0}, 1.5f, 0.3f), 2, 0.02);
}

/// A matte, emitting core inside a glass ball inside a furnace: photons cross the boundary both
/// ways.
TEST(Dielectric, LampInsideTheDielectric) {
    const mock::Scene scene = furnace_with_ball(1.5f, 0.3f);
    constexpr std::uint32_t kSize = 24;
    Settings settings = mock::small_settings(22, 40000);
    settings.max_eye_depth = 64;
    settings.max_photon_depth = 32;
    settings.start_radius = 1.5;
    const auto camera = mock::camera_along_y({0, -1.9f, 0}, 0.08f, kSize, kSize);
    const auto r = mock::render(scene, camera, kSize, kSize, settings, 40);
    EXPECT_NEAR(r.film.mean(), 2, 0.03);
}

}  // namespace
}  // namespace aips::dielectric_test
