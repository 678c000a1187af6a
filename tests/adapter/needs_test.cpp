// Protects: what a scene doesn't need is not run, the log says so, and the image is the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "render_mock.h"

namespace {

using namespace aips;

bool logged(const mock::Log& log, const std::string& text) {
    return std::any_of(log.lines.begin(), log.lines.end(),
                       [&](const std::string& l) { return l.find(text) != std::string::npos; });
}

mock::Rendering render_box(const Settings& settings) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 16, 12);
    return mock::render(scene, camera, 16, 12, settings, 2);
}

TEST(Needs, NoPhotonsWhenShadowRaysCarryAll) {
    Settings settings = mock::small_settings(61, 5000);
    settings.max_photon_depth = 1;
    const auto r = render_box(settings);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: shadow rays carry all light"));
    EXPECT_GT(r.film.mean(), 0);
}

TEST(Needs, NoGuideIsBuiltWithoutPhotonsToGuide) {
    for (const GuideKind guide : {GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = mock::small_settings(61, 5000);
        settings.max_photon_depth = 1;
        settings.guide = guide;
        const auto r = render_box(settings);
        EXPECT_EQ(r.statistics.guide_bytes, 0u) << mock::name(guide);
        EXPECT_TRUE(logged(r.log, "skipped guide: no photons to guide")) << mock::name(guide);
    }
}

TEST(Needs, NoPhotonsWithoutLight) {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    scene.finish();
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, 8, 8);
    const auto r = mock::render(scene, camera, 8, 8, mock::small_settings(62, 5000), 2);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: no light emits"));
    EXPECT_EQ(r.film.mean(), 0);
}

TEST(Needs, NoPhotonsWithoutReceivers) {
    mock::Scene scene;
    mock::Surface wall;
    wall.material.kind = mock::Material::Kind::Mirror;
    wall.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    scene.finish();
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, 8, 8);
    const auto r = mock::render(scene, camera, 8, 8, mock::small_settings(63, 5000), 1);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_TRUE(logged(r.log, "skipped photon pass: no surface takes photons"));
}

/// A camera that sees no receiver shoots no photons either.
TEST(Needs, NoPhotonsWithoutVisiblePoints) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, 5, 0}, 0.1f, 8, 8);
    const auto r = mock::render(scene, camera, 8, 8, mock::small_settings(64, 5000), 2);
    EXPECT_EQ(r.statistics.photon_paths, 0u);
    EXPECT_EQ(r.film.mean(), 0);
}

/// Direct photons are never stored under next-event estimation: with one bounce allowed, every
/// landing is at depth two.
TEST(Needs, DirectPhotonsAreDropped) {
    Settings settings = mock::small_settings(65, 5000);
    settings.max_photon_depth = 2;
    const auto with_rays = render_box(settings);
    EXPECT_TRUE(logged(with_rays.log, "skipped direct photons"));
    settings.direct_light_sampling = false;
    const auto alone = render_box(settings);
    EXPECT_GT(alone.statistics.landings, with_rays.statistics.landings);
}

TEST(Needs, UnguidedRunsHaveNoGuide) {
    const auto r = render_box(mock::small_settings(66, 5000));
    EXPECT_EQ(r.statistics.guide_bytes, 0u);
    EXPECT_EQ(r.statistics.guided_bounces, 0u);
    EXPECT_TRUE(logged(r.log, "skipped guide: not asked for"));
}

}  // namespace
