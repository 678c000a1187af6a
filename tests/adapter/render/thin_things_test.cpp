// Protects light on things that are thinner than the gather radius: what photons lose there, eye
// paths bring.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::thin_things_test {
namespace {

constexpr std::uint32_t kSize = 24;

/// A closed box of albedo 1/2 that emits 1 everywhere shows 2 everywhere, and so do strips of the
/// same in front of its wall, two thirds of the way empty between them.
mock::Scene furnace_with_strips() {
    mock::Scene scene;
    mock::Surface wall;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    constexpr float kWidth = 0.04f, kThickness = 1e-3f;
    for (int i = -6; i < 6; ++i) {
        const float x = 0.12f * float(i) + kWidth;
        wall.shape = mock::Quad{{x, 0.5f, -0.7f}, {kWidth, 0, 0}, {0, 0, 1.4f}};
        scene.add(wall);
        wall.shape = mock::Quad{{x, 0.5f + kThickness, -0.7f}, {0, 0, 1.4f}, {kWidth, 0, 0}};
        scene.add(wall);
    }
    scene.finish();
    return scene;
}

struct Seen {
    double mean = 0;
    std::uint64_t continued = 0;
};

Seen seen(bool continue_eye_paths, RadiusKind radius) {
    const mock::Scene scene = furnace_with_strips();
    Settings settings = mock::small_settings(31, 5000);
    settings.max_photon_depth = 16;
    settings.radius = radius;
    if (radius == RadiusKind::Schedule) settings.start_radius = 3;
    settings.continue_eye_paths = continue_eye_paths;
    const auto camera = mock::camera_along_y({0, -0.3f, 0}, 0.7f, kSize, kSize);
    const auto r = mock::render(scene, camera, kSize, kSize, settings, 256);
    return {r.film.mean(), r.statistics.continued_paths};
}

/// Photons stay too few as the radius of these passes reaches from strip to strip: 6 % of the light
/// of an image in which strips are a quarter.
TEST(ThinThings, AreAsBrightAsWhatIsAroundThem) {
    for (const RadiusKind radius : {RadiusKind::Schedule, RadiusKind::Adaptive}) {
        EXPECT_LT(seen(false, radius).mean, 1.95);
        const Seen shared = seen(true, radius);
        EXPECT_NEAR(shared.mean, 2, 0.02);
        EXPECT_GT(shared.continued, 10000u);
    }
}

}  // namespace
}  // namespace aips::thin_things_test
