// Protects the first look at a scene: the share of photon paths that are seen is what it ought to
// be, it is looked for longer where it is small, and where it is large guide=adaptive gives the
// bits of guide=none. Chains, where it is small: guide_chains_test.cpp.
#include "plan/guide_scout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "eye/traced_eye_image.h"
#include "render_mock.h"

namespace aips::guide_scout_test {
namespace {

constexpr std::uint32_t kWidth = 16, kHeight = 12;

bool says(const mock::Log& log, std::string_view what) {
    return std::ranges::any_of(
        log.lines, [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

mock::Rendering render(const mock::View& view, GuideKind guide, std::uint32_t photons) {
    Settings settings = mock::small_settings(7, photons);
    settings.guide = guide;
    settings.guide_scout = true;
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
    EXPECT_NEAR(scout_photons(scene, settings, 0, image, 0.02f).seen_share(), 1.0 / 6, 0.02);
}

TEST(SeenShare, IsLookedForLongerWhereItIsSmall) {
    constexpr std::uint32_t kSize = 16;
    const mock::View view = mock::wide_view(20, kSize, kSize);
    Settings settings = mock::small_settings(8, 1);
    settings.direct_light_sampling = false;
    const EyeImage image =
        mock::traced_eye_image(view.scene, view.camera, kSize, kSize * kSize, settings);
    const auto counts = [&](bool chains) {
        settings.guide_chains = chains;
        return scout_photons(view.scene, settings, 0, image, 0.05f);
    };
    const SeenPaths first = counts(false), longer = counts(true);
    EXPECT_EQ(first.traced, 16384u);
    EXPECT_LT(first.seen, 32u);
    EXPECT_GT(longer.traced, first.traced);
    EXPECT_TRUE(longer.seen >= 32 || longer.traced == 16 * first.traced);
    EXPECT_GE(longer.seen, first.seen);
}

/// Small radii leave gaps between visible points, which the share that comes near does not have.
TEST(SeenShare, IsLessThanWhatComesNear) {
    constexpr std::uint32_t kSize = 32;
    const mock::View view = mock::wide_view(3, kSize, kSize);
    Settings settings = mock::small_settings(8, 1);
    settings.direct_light_sampling = false;
    const EyeImage image =
        mock::traced_eye_image(view.scene, view.camera, kSize, kSize * kSize, settings);
    const SeenPaths wide = scout_photons(view.scene, settings, 0, image, 0.04f);
    const SeenPaths narrow = scout_photons(view.scene, settings, 0, image, 0.005f);
    EXPECT_GE(wide.near, wide.seen);
    EXPECT_LT(narrow.seen_share(), 0.5 * wide.seen_share());
    EXPECT_GT(narrow.near_share(), narrow.seen_share());
}

TEST(PhotonWay, GoesByTheShareThatIsSeen) {
    Settings settings;
    const auto way = [&](std::uint64_t near, std::uint64_t seen) {
        return photon_way(settings, {near, seen, 240'000});
    };
    EXPECT_EQ(way(240'000, 240'000), PhotonWay::Unguided);
    EXPECT_EQ(way(80'000, 50'000), PhotonWay::Unguided);
    EXPECT_EQ(way(79'999, 50'000), PhotonWay::Guided);
    EXPECT_EQ(way(200, 120), PhotonWay::Guided);
    EXPECT_EQ(way(200, 119), PhotonWay::Chains);
    EXPECT_EQ(way(200, 2), PhotonWay::Chains);
    EXPECT_EQ(way(200, 1), PhotonWay::Guided) << "chains might find none in most passes";
    settings.guide_chains = false;
    EXPECT_EQ(way(200, 119), PhotonWay::Guided);
}

/// With a number of photons that is given, and with one that follows the noise.
TEST(GuideScout, WhereMostIsSeenPhotonsGoAsWithoutAGuide) {
    const mock::View view = mock::half_mirror_view(kWidth, kHeight);
    for (const std::uint32_t photons : {5000u, 0u}) {
        const mock::Rendering scouted = render(view, GuideKind::Adaptive, photons);
        const mock::Rendering unguided = render(view, GuideKind::None, photons);
        EXPECT_TRUE(says(scouted.log, "skipped the guide:"));
        EXPECT_EQ(scouted.film.image(), unguided.film.image()) << photons;
        EXPECT_EQ(scouted.statistics.photon_paths, unguided.statistics.photon_paths);
        EXPECT_EQ(scouted.statistics.guide_bytes, 0u);
    }
}

TEST(GuideScout, WhereLittleIsSeenTheGuideStays) {
    const mock::View view = mock::wide_view(3, kWidth, kHeight);
    const mock::Rendering scouted = render(view, GuideKind::Adaptive, 5000);
    EXPECT_FALSE(says(scouted.log, "skipped the guide:"));
    EXPECT_GT(scouted.statistics.guide_bytes, 0u);
}

}  // namespace
}  // namespace aips::guide_scout_test
