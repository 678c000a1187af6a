// Protects that Markov chains take the adaptive guide's place where a first look finds that next to
// no photon path is seen, and nowhere else: the same expectation, the same bits for any number of
// threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "block_test.h"
#include "render_mock.h"

namespace {

using namespace aips;

constexpr std::uint32_t kWidth = 16, kHeight = 12;
constexpr std::uint32_t kPhotons = 400'000;

Settings adaptive(std::uint64_t seed, bool chains) {
    Settings settings = mock::small_settings(seed, kPhotons);
    settings.guide = GuideKind::Adaptive;
    settings.guide_scout = true;
    settings.guide_chains = chains;
    settings.start_radius = 3;
    settings.direct_light_sampling = false;
    return settings;
}

mock::Rendering render(const mock::View& view, const Settings& settings, std::uint32_t passes) {
    return mock::render(view.scene, view.camera, kWidth, kHeight, settings, passes);
}

/// One unguided photon path in 3000 or so comes within reach of the patch.
mock::View wide_view() {
    return mock::wide_view(26, kWidth, kHeight);
}

bool by_chains(const mock::Rendering& rendering) {
    return std::any_of(rendering.log.lines.begin(), rendering.log.lines.end(),
                       [](const std::string& line) {
                           return line.starts_with("skipped the guide: Markov chains");
                       });
}

TEST(GuideChains, TakeTheGuidesPlaceWhereNextToNothingIsSeen) {
    const auto r = render(wide_view(), adaptive(1, true), 2);
    EXPECT_TRUE(by_chains(r));
    EXPECT_NEAR(double(r.statistics.measured_paths), kPhotons, 128) << "half of the paths";
    EXPECT_EQ(r.statistics.photon_paths, 2 * kPhotons);
    EXPECT_EQ(r.statistics.guide_bytes, 0u);
}

TEST(GuideChains, StayOutWhereEnoughIsSeenOrTheyAreNotWanted) {
    const auto seen = render(mock::wide_view(6, kWidth, kHeight), adaptive(2, true), 2);
    EXPECT_FALSE(by_chains(seen));
    EXPECT_EQ(seen.statistics.measured_paths, 0u);
    EXPECT_FALSE(by_chains(render(wide_view(), adaptive(3, false), 2)));
}

/// A radius that was asked for is the same for all methods.
TEST(GuideChains, StartAtHalfTheAutomaticRadius) {
    const auto radius = [](GuideKind guide, double start) {
        Settings settings = adaptive(6, true);
        settings.guide = guide;
        settings.start_radius = start;
        return render(wide_view(), settings, 1).statistics.radius;
    };
    EXPECT_FLOAT_EQ(radius(GuideKind::Adaptive, 0), radius(GuideKind::None, 0) / 2);
    EXPECT_EQ(radius(GuideKind::Adaptive, 1.5), radius(GuideKind::None, 1.5));
}

/// In each mode, and with radii that follow the light.
TEST(GuideChains, AreThoseOfPhotonSamplerAmc) {
    const auto expect_same = [](Mode mode, RadiusKind radius) {
        Settings settings = adaptive(4, true);
        settings.photons_per_pass = 60'000;
        settings.mode = mode;
        settings.radius = radius;
        const auto chained = render(wide_view(), settings, 3);
        EXPECT_TRUE(by_chains(chained));
        settings.guide = GuideKind::None;
        settings.photon_sampler = PhotonSampler::AdaptiveChains;
        EXPECT_EQ(chained.film.image(), render(wide_view(), settings, 3).film.image());
    };
    for (const Mode mode : {Mode::Progressive, Mode::PhotonMap, Mode::Ppm})
        expect_same(mode, RadiusKind::Schedule);
    expect_same(Mode::Progressive, RadiusKind::Adaptive);
}

TEST(GuideChains, TakeLongPasses) {
    Settings settings = adaptive(6, true);
    settings.photons_per_pass = 0;
    const auto r = render(wide_view(), settings, 8);
    EXPECT_TRUE(by_chains(r));
    EXPECT_EQ(r.statistics.photon_paths, 8 * 65536u);
    EXPECT_GT(r.statistics.visible_paths, 0u);
}

/// Family-wise significance of 1 %, fixed seeds; an eighth more or less would be found. Most of
/// what chains leave uncertain is one scale for all, by the independent paths that were seen.
TEST(GuideChains, HaveTheExpectationOfUnguidedPhotons) {
    const auto renders = [](GuideKind guide, std::uint64_t first_seed) {
        statistics::BlockMeans means;
        for (unsigned s = 0; s < 16; ++s) {
            Settings settings = adaptive(first_seed + s, true);
            settings.guide = guide;
            const auto r = render(wide_view(), settings, 4);
            EXPECT_EQ(by_chains(r), guide == GuideKind::Adaptive);
            means.push_back(statistics::block_means(mock::luminances(r.film), kWidth, kHeight, 8));
        }
        return means;
    };
    const auto plain = renders(GuideKind::None, 100), chained = renders(GuideKind::Adaptive, 200);
    const auto same = statistics::compare(plain, chained, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, 0.125) << same.describe();
}

/// The patch of wide_view and its wall under a sheet that all light has to pass, with lobes of all
/// kinds and shading normals tilted by 3 degrees.
mock::View roofed_view() {
    mock::Scene scene;
    mock::Surface ground;
    constexpr float kHalf = 26;
    ground.shape = mock::Quad{{-kHalf, -kHalf, 0}, {2 * kHalf, 0, 0}, {0, 2 * kHalf, 0}};
    scene.add(ground);
    mock::Surface wall;
    wall.shape = mock::Quad{{0.6f, -1, 0}, {0, 2, 0}, {0, 0, 1}};
    scene.add(wall);
    scene.add(mock::tilted_sheet(mock::Quad{{-1, -1, 1.1f}, {2, 0, 0}, {0, 2, 0}}));
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-kHalf, -kHalf, 3}, {0, 2 * kHalf, 0}, {2 * kHalf, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {1, 1, 1};
    scene.add(lamp);
    scene.finish();
    return {std::move(scene), {{0, 0, 1}, {0, 0, -1}, {0.4f, 0, 0}, {0, 0.3f, 0}, kWidth, kHeight}};
}

/// As above, where bounces draw as many numbers as any do.
TEST(GuideChains, HaveTheExpectationOfUnguidedPhotonsUnderATiltedSheet) {
    const auto view = roofed_view();
    const auto renders = [&view](GuideKind guide, std::uint64_t first_seed) {
        statistics::BlockMeans means;
        for (unsigned s = 0; s < 16; ++s) {
            Settings settings = adaptive(first_seed + s, true);
            settings.guide = guide;
            const auto r = render(view, settings, 4);
            EXPECT_EQ(by_chains(r), guide == GuideKind::Adaptive);
            means.push_back(statistics::block_means(mock::luminances(r.film), kWidth, kHeight, 8));
        }
        return means;
    };
    const auto plain = renders(GuideKind::None, 300), chained = renders(GuideKind::Adaptive, 400);
    const auto same = statistics::compare(plain, chained, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, 0.125) << same.describe();
}

TEST(GuideChains, SameBitsForAnyNumberOfThreads) {
    const auto image_with = [](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        std::size_t(threads));
        return render(wide_view(), adaptive(5, true), 2).film.image();
    };
    const auto one = image_with(1);
    EXPECT_EQ(one, image_with(2));
    EXPECT_EQ(one, image_with(7));
}

}  // namespace
