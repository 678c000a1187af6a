// Protects: `maxdepth` bounds camera and photon path together, whoever joins the two: in a closed
// box of constant albedo and emission the radiance is the sum over the bounces that it allows.
//
// And that specular surfaces do not count where no depth was asked for.
#include <gtest/gtest.h>

#include <functional>

#include "render_mock.h"
#include "test_form.h"

namespace aips::whole_depth_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kSize = 24;
constexpr double kAlbedo = 0.5;

/// Emission 1, up to `bounces` scatterings.
double furnace_radiance(unsigned bounces) {
    double sum = 0, term = 1;
    for (unsigned k = 0; k <= bounces; ++k, term *= kAlbedo)
        sum += term;
    return sum;
}

mock::Material half_mirror_wall() {
    mock::Material wall;
    wall.kind = Kind::LambertAndMirror;
    wall.reflectance = wall.specular = {0.25f, 0.25f, 0.25f};
    return wall;
}

/// A pane through the middle of the box lets all pass straight: no bounce.
mock::Scene furnace(const mock::Material& wall) {
    mock::Scene scene;
    mock::Surface surface;
    surface.material = wall;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    mock::Material null;
    null.kind = Kind::Null;
    scene.add({mock::Quad{{-1, 0.2f, -1}, {2, 0, 0}, {0, 0, 2}}, null});
    scene.finish();
    return scene;
}

struct Way {
    const char* name;
    std::function<void(Settings&)> choose;
    unsigned passes = 1;  ///< factor
};

const std::vector<Way>& ways() {
    static const std::vector<Way> all{
        {"no guide", [](Settings&) {}},
        {"photons alone", [](Settings& s) { s.direct_light_sampling = false; }},
        {"paper", [](Settings& s) { s.guide = GuideKind::Paper; }},
        {"adaptive", [](Settings& s) { s.guide = GuideKind::Adaptive; }},
        {"chains", [](Settings& s) { s.photon_sampler = PhotonSampler::AdaptiveChains; }},
        {"photon map", [](Settings& s) { s.mode = Mode::PhotonMap; }},
        {"ppm", [](Settings& s) { s.mode = Mode::Ppm; }},
        {"eye paths", [](Settings& s) { s.photons_per_pass = 300; }, 20},
    };
    return all;
}

void expect_partial_sums(const mock::Material& wall) {
    const mock::Scene scene = furnace(wall);
    const auto camera = mock::camera_along_y({0, -0.5f, 0}, 0.4f, kSize, kSize);
    for (const Way& way : ways()) {
        for (const std::uint32_t bounces : {0u, 1u, 2u, 3u, 4u, 6u}) {
            SCOPED_TRACE(testing::Message() << way.name << ", maxdepth " << bounces);
            Settings settings = mock::small_settings(5, 30000);
            settings.start_radius = 2;
            settings.max_eye_depth = settings.max_photon_depth = 40;
            settings.max_bounces = bounces;
            way.choose(settings);
            const auto r = mock::render(scene, camera, kSize, kSize, settings, way.passes * 10);
            EXPECT_NEAR(r.film.mean() / furnace_radiance(bounces), 1, 0.01);
        }
    }
}

TEST(WholeDepth, FurnaceOfMatteWalls) {
    expect_partial_sums({});
}

/// Eye paths have bounces of their own before their visible points.
TEST(WholeDepth, FurnaceOfHalfMirrors) {
    expect_partial_sums(half_mirror_wall());
}

/// Fog in a black box around a lamp: what photons bring from elsewhere in the fog is a second
/// bounce, and shadow rays' light is the first.
TEST(WholeDepth, FogCountsItsCollisions) {
    mock::Material black;
    black.reflectance = {0, 0, 0};
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {mock::Quad{}, black});
    scene.add({mock::Quad{{-0.5f, -0.5f, 0.9f}, {0, 1, 0}, {1, 0, 0}}, black, {5, 5, 5}});
    scene.finish();
    mock::Fog fog;
    fog.scattering = {1, 1, 1};
    scene.fill(fog);
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 0.4f, kSize, kSize);
    const auto mean = [&](std::uint32_t bounces, std::uint32_t photon_depth) {
        Settings settings = mock::small_settings(5, 30000);
        settings.max_photon_depth = photon_depth;
        settings.max_bounces = bounces;
        return mock::render(scene, camera, kSize, kSize, settings, 10).film.mean();
    };
    EXPECT_EQ(mean(0, 16), 0);
    for (const std::uint32_t bounces : {1u, 2u, 3u})
        EXPECT_NEAR(mean(bounces, 16) / mean(kAnyBounces, bounces), 1, 1e-6) << bounces;
    EXPECT_GT(mean(2, 16), 1.1 * mean(1, 16));
    EXPECT_GT(mean(3, 16), 1.02 * mean(2, 16));
}

/// A bound that no path reaches changes no bit.
TEST(WholeDepth, WideBoundsChangeNothing) {
    const mock::View view = mock::half_mirror_view(kSize, kSize);
    Settings settings = mock::small_settings(5, 3000);
    settings.guide = GuideKind::Adaptive;
    settings.max_eye_depth = settings.max_photon_depth = 8;
    const auto luminances = [&](std::uint32_t bounces) {
        settings.max_bounces = bounces;
        return mock::luminances(
            mock::render(view.scene, view.camera, kSize, kSize, settings, 4).film);
    };
    EXPECT_EQ(luminances(kAnyBounces), luminances(16));
    EXPECT_NE(luminances(kAnyBounces), luminances(3));
}

/// Panes of index 1 that reflect nothing but turn light as glass does, `count` of them close
/// together over a floor.
mock::View floor_under_panes(unsigned count) {
    mock::Scene scene;
    mock::Material black, pane;
    black.reflectance = {0, 0, 0};
    pane.kind = Kind::Glass;
    pane.reflectance = {1, 1, 1};
    pane.index = 1;
    scene.add({mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, {}});
    scene.add({mock::Quad{{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}}, black, {5, 5, 5}});
    for (unsigned i = 0; i < count; ++i)
        scene.add({mock::Quad{{-3, -3, 1 + 0.02f * float(i)}, {6, 0, 0}, {0, 6, 0}}, pane});
    scene.finish();
    return {std::move(scene), {{0, 0, 1.8f}, {0, 0, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, kSize, kSize}};
}

TEST(DefaultDepth, PanesDoNotCount) {
    const auto mean = [](unsigned panes, std::uint32_t depth) {
        const mock::View view = floor_under_panes(panes);
        Settings settings = mock::small_settings(5, 60000);
        settings.max_eye_depth = settings.max_photon_depth = depth;
        return mock::render(view.scene, view.camera, kSize, kSize, settings, 10).film.mean();
    };
    const double bare = mean(0, 0);
    EXPECT_NEAR(mean(24, 0) / bare, 1, 0.02);
    EXPECT_LT(mean(24, 16), 0.1 * bare);  // a depth that is given means what it says
    EXPECT_NEAR(mean(24, 26) / bare, 1, 0.02);
}

/// Continued eye paths count as photons do that pass the same mirrors.
TEST(DefaultDepth, ContinuedPathsAndPhotonsCountAlike) {
    mock::Scene scene;
    mock::Material black, mirror;
    black.reflectance = {0, 0, 0};
    mirror.kind = Kind::Mirror;
    mirror.reflectance = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {mock::Quad{}, {}});
    scene.add({mock::Quad{{-0.5f, -0.5f, 0.95f}, {0, 1, 0}, {1, 0, 0}}, black, {5, 5, 5}});
    scene.add({mock::Quad{{-0.95f, -1, -1}, {0, 2, 0}, {0, 0, 2}}, mirror});
    scene.add({mock::Quad{{0.95f, -1, -1}, {0, 0, 2}, {0, 2, 0}}, mirror});
    scene.finish();
    const auto camera = mock::camera_along_y({0, -0.5f, -0.3f}, 0.4f, kSize, kSize);
    Settings settings = mock::small_settings(31, 60000);
    settings.continue_eye_paths = false;
    const double photons = mock::render(scene, camera, kSize, kSize, settings, 40).film.mean();
    settings.continue_eye_paths = true;
    settings.photons_per_pass = 400;
    const double shared = mock::render(scene, camera, kSize, kSize, settings, 400).film.mean();
    EXPECT_NEAR(shared / photons, 1, 0.01);
}

}  // namespace
}  // namespace aips::whole_depth_test
