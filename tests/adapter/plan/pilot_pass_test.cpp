// Protects the pilot pass of a scene: the share of photon paths that are seen is what it ought to
// be, and where it is large guide=adaptive gives the bits of guide=none. What comes where it is
// small: exploration_test.cpp.
#include "plan/pilot_pass.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "eye/traced_eye_image.h"
#include "render_mock.h"

namespace aips::pilot_pass_test {
namespace {

constexpr std::uint32_t kWidth = 16, kHeight = 12;

bool says(const mock::Log& log, std::string_view what) {
    return std::ranges::any_of(
        log.lines, [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

mock::Rendering render(const mock::View& view, GuideKind guide, std::uint32_t photons) {
    Settings settings = mock::small_settings(7, photons);
    settings.guide = guide;
    settings.pilot_pass = true;
    return mock::render(view.scene, view.camera, kWidth, kHeight, settings, 6);
}

/// A lamp in the middle of a box, of whose six walls the eye sees one.
TEST(SeenShare, IsThatOfTheWallThatIsSeen) {
    mock::Scene scene;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
    scene.add_point_light({0, 0, 0}, {1, 1, 1});
    scene.finish();
    Settings settings = mock::small_settings(8, 1);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 1;
    constexpr std::uint32_t kSize = 128;
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, kSize, kSize);
    const EyeImage image = mock::traced_eye_image(scene, camera, kSize, kSize * kSize, settings);
    // The rim of the other walls, a radius wide, is within reach of what is seen.
    EXPECT_NEAR(trace_pilot_pass(scene, settings, 0, image, 0.02f).seen_share(), 1.0 / 6, 0.02);
}

/// Small radii leave gaps between visible points, which the share that comes near does not have.
TEST(SeenShare, IsLessThanWhatComesNear) {
    constexpr std::uint32_t kSize = 32;
    const mock::View view = mock::wide_view(3, kSize, kSize);
    Settings settings = mock::small_settings(8, 1);
    settings.direct_light_sampling = false;
    const EyeImage image =
        mock::traced_eye_image(view.scene, view.camera, kSize, kSize * kSize, settings);
    const SeenPaths wide = trace_pilot_pass(view.scene, settings, 0, image, 0.04f);
    const SeenPaths narrow = trace_pilot_pass(view.scene, settings, 0, image, 0.005f);
    EXPECT_GE(wide.near, wide.seen);
    EXPECT_LT(narrow.seen_share(), 0.5 * wide.seen_share());
    EXPECT_GT(narrow.near_share(), narrow.seen_share());
}

TEST(PhotonWay, GoesByTheShareThatComesNear) {
    const auto way = [](std::uint64_t near) { return photon_way({near, near / 2, 240'000}); };
    EXPECT_EQ(way(240'000), PhotonWay::Unguided);
    EXPECT_EQ(way(80'000), PhotonWay::Unguided);
    EXPECT_EQ(way(79'999), PhotonWay::Guided);
    EXPECT_EQ(way(0), PhotonWay::Guided);
    EXPECT_TRUE(seen_too_seldom({200, 31, 16384}));
    EXPECT_FALSE(seen_too_seldom({200, 32, 16384}));
}

/// With a number of photons that is given, and with one that follows the noise.
TEST(PilotPass, WhereMostIsSeenPhotonsGoAsWithoutAGuide) {
    const mock::View view = mock::half_mirror_view(kWidth, kHeight);
    for (const std::uint32_t photons : {5000u, 0u}) {
        const mock::Rendering piloted = render(view, GuideKind::Adaptive, photons);
        const mock::Rendering unguided = render(view, GuideKind::None, photons);
        EXPECT_TRUE(says(piloted.log, "skipped the guide:"));
        EXPECT_EQ(piloted.film.image(), unguided.film.image()) << photons;
        EXPECT_EQ(piloted.statistics.photon_paths, unguided.statistics.photon_paths);
        EXPECT_EQ(piloted.statistics.guide_bytes, 0u);
    }
}

TEST(PilotPass, WhereLittleIsSeenTheGuideStays) {
    const mock::View view = mock::wide_view(3, kWidth, kHeight);
    const mock::Rendering piloted = render(view, GuideKind::Adaptive, 5000);
    EXPECT_FALSE(says(piloted.log, "skipped the guide:"));
    EXPECT_GT(piloted.statistics.guide_bytes, 0u);
}

}  // namespace
}  // namespace aips::pilot_pass_test
