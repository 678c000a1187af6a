// Protects the ends of paths: what a shadow ray passes straight next to a lamp counts in no
// strategy, so that limits of the depth mean the same in all (docs/understand/
// who-carries-which-light.md).
//
// Images with a pane before the lamp have the mean of those without it, and those whose eye paths
// go on the mean of those of photons alone. A strategy that counted the pane would lose half of the
// light or more.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::depth_limit_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kSize = 16;

/// A floor, and a wall beside it if asked for, under a lamp, with a pane close below the lamp or
/// without it.
mock::Scene under_lamp(const mock::Material& floor, bool pane, bool wall = false) {
    mock::Scene scene;
    scene.add({mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, floor});
    if (wall) scene.add({mock::Quad{{-1, 1, 0}, {0, 0, 2}, {2, 0, 0}}, {}});
    mock::Material black, null;
    black.reflectance = {0, 0, 0};
    null.kind = Kind::Null;
    scene.add({mock::Quad{{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}}, black, {5, 5, 5}});
    if (pane) scene.add({mock::Quad{{-3, -3, 1.9f}, {6, 0, 0}, {0, 6, 0}}, null});
    scene.finish();
    return scene;
}

mock::Camera camera_down() {
    return {{0, 0, 1}, {0, 0, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, kSize, kSize};
}

double mean_of(const mock::Scene& scene, const mock::Camera& camera, const Settings& settings,
               std::uint32_t passes = 20) {
    return mock::render(scene, camera, kSize, kSize, settings, passes).film.mean();
}

/// Half of the lamp's light on the floor is the bounce's, by the weights.
TEST(DepthLimit, AGlossyBounceBringsItsShareThroughAPane) {
    mock::Material gloss;
    gloss.kind = Kind::Phong;
    gloss.exponent = 40;
    const mock::Camera camera{{0, -1, 1}, {0, 0.6f, -0.8f}, {0.2f, 0, 0}, {0, 0.16f, 0.12f}, kSize,
                              kSize};
    Settings settings = mock::small_settings(31, 1000);
    settings.max_eye_depth = 2;
    const double bare = mean_of(under_lamp(gloss, false), camera, settings, 200);
    EXPECT_NEAR(mean_of(under_lamp(gloss, true), camera, settings, 200) / bare, 1, 0.01);
}

/// Of photons whose only surface is the floor.
TEST(DepthLimit, APhotonsPaneCountsForNothing) {
    Settings settings = mock::small_settings(31, 60000);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 1;
    const double bare = mean_of(under_lamp({}, false), camera_down(), settings);
    EXPECT_NEAR(mean_of(under_lamp({}, true), camera_down(), settings) / bare, 1, 0.01);
}

TEST(DepthLimit, ContinuedPathsAndPhotonsCountAlike) {
    const mock::Scene scene = under_lamp({}, true, true);
    const mock::Camera camera{{0, 0.6f, 1}, {0, 0, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, kSize, kSize};
    for (const std::uint32_t depth : {2u, 3u, 4u}) {
        SCOPED_TRACE(depth);
        Settings settings = mock::small_settings(31, 60000);
        settings.start_radius = 0.25;
        settings.max_photon_depth = depth;
        settings.continue_eye_paths = false;
        const double photons = mean_of(scene, camera, settings, 40);
        settings.continue_eye_paths = true;
        settings.photons_per_pass = 400;  // so few that nearly all is the eye's
        const auto shared = mock::render(scene, camera, kSize, kSize, settings, 400);
        EXPECT_GT(shared.statistics.continued_paths, shared.statistics.eye_paths / 2);
        EXPECT_NEAR(shared.film.mean() / photons, 1, 0.005);
        settings.max_photon_depth = 1;
        const double direct = mean_of(scene, camera, settings);
        EXPECT_GT(photons, 1.05 * direct);  // what is compared is there
    }
}

}  // namespace
}  // namespace aips::depth_limit_test
