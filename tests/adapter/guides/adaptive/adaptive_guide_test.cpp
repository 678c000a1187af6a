// Protects guide=adaptive: the same expectation as unguided photons, whatever it learns, and less
// variance where photons are rarely worth something.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "block_test.h"
#include "render_mock.h"
#include "run_on_threads.h"
#include "test_form.h"

namespace aips::adaptive_guide_test {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 24;

using mock::View;

/// All light by photons, in a box with a lamp and a ball that is half a mirror.
View lamp_and_mirror() {
    return mock::half_mirror_view(kWidth, kHeight);
}

/// A dim corridor with a lamp near one end, seen at the other: directions along it are worth most.
View lamp_in_a_corridor() {
    mock::Scene scene;
    mock::Surface wall, lamp;
    wall.material.reflectance = {0.3f, 0.3f, 0.3f};
    scene.add_box({-1, -8, -1}, {1, 1, 1}, wall);
    lamp.shape = mock::Quad{{-0.8f, -7.8f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.emitted = {30, 30, 30};
    scene.add(lamp);
    scene.finish();
    return {std::move(scene), mock::camera_along_y({0, -0.95f, 0}, 0.9f, kWidth, kHeight)};
}

/// A pillar on a ground twenty times as wide as what is seen of it, under a sun.
View wide_ground() {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-20, -20, 0}, {40, 0, 0}, {0, 40, 0}};
    scene.add(ground);
    mock::Surface pillar;
    scene.add_box({0.5f, 0.5f, 2}, {-0.5f, -0.5f, 0}, pillar);  // inside out: faces look outwards
    scene.add_distant_light({normalize({1, 0.5f, 1}), 0.999f}, {10, 10, 10});
    scene.finish();
    return {std::move(scene),
            {{1.5f, 0, 4}, {0, 0, -1}, {0.25f, 0, 0}, {0, 0.25f, 0}, kWidth, kHeight}};
}

/// Block means of renders with different seeds.
statistics::BlockMeans renders(const View& view, const std::function<void(Settings&)>& choose,
                               unsigned seeds, std::uint64_t first_seed, unsigned block = 8,
                               unsigned passes = 6) {
    statistics::BlockMeans means;
    for (unsigned s = 0; s < seeds; ++s) {
        // alpha 1 keeps the radius, and a fixed start radius is the same for all: equal bias.
        Settings settings = mock::small_settings(first_seed + s, 20000);
        settings.start_radius = 1;
        settings.direct_light_sampling = false;
        choose(settings);
        const auto r = mock::render(view.scene, view.camera, kWidth, kHeight, settings, passes);
        means.push_back(statistics::block_means(mock::luminances(r.film), kWidth, kHeight, block));
    }
    return means;
}

void plain(Settings& settings) {
    settings.guide = GuideKind::None;
}
void adaptive(Settings& settings) {
    settings.guide = GuideKind::Adaptive;
}

/// Only directions are guided.
void bounces_alone(Settings& settings) {
    adaptive(settings);
    settings.guide_emission = settings.guide_survival = false;
}
void no_bounces(Settings& settings) {
    bounces_alone(settings);
    settings.guide_bounces = false;
}
/// The same within a wider radius, which more photons reach.
std::function<void(Settings&)> widely(void (*choose)(Settings&)) {
    return [choose](Settings& settings) {
        choose(settings);
        settings.start_radius = 3;
    };
}

/// Of the pixels of eight renders.
double pixel_variance(const View& view, void (*choose)(Settings&), std::uint64_t first_seed,
                      unsigned passes) {
    return statistics::mean_variance(renders(view, widely(choose), 8, first_seed, 1, passes));
}

unsigned seeds() {
    return statistics::sized(9u, 16u);
}

/// 13 tests per comparison at a family-wise significance of 1 %, fixed seeds; a planted bias must
/// be found.
void expect_same(const statistics::BlockMeans& a, const statistics::BlockMeans& b,
                 double planted = statistics::sized(0.045, 0.03)) {
    const auto same = statistics::compare(a, b, 0.01);
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, planted) << same.describe();
    const auto found = statistics::compare(a, statistics::scaled(b, 1 + planted), 0.01);
    EXPECT_TRUE(found.differs()) << "a planted bias went unnoticed: " << found.describe();
}

TEST(AdaptiveGuide, SameExpectationInAClosedBox) {
    const View view = lamp_and_mirror();
    expect_same(renders(view, plain, seeds(), 1000), renders(view, adaptive, seeds(), 2000));
}

TEST(AdaptiveGuide, SameExpectationWithEachPartAlone) {
    const View view = lamp_and_mirror();
    const auto reference = renders(view, plain, seeds(), 1000);
    const auto emission = [](Settings& s) {
        adaptive(s);
        s.guide_survival = s.guide_bounces = false;
    };
    const auto survival = [](Settings& s) {
        adaptive(s);
        s.guide_emission = s.guide_bounces = false;
    };
    expect_same(reference, renders(view, emission, seeds(), 3000));
    expect_same(reference, renders(view, survival, seeds(), 4000));
}

TEST(AdaptiveGuide, SameExpectationWithGuidedBounces) {
    const View view = lamp_in_a_corridor();
    const unsigned many = statistics::sized(9u, 24u);
    const double planted = statistics::sized(0.09, 0.05);
    const auto reference = renders(view, plain, many, 1000, 8, 12);
    expect_same(reference, renders(view, bounces_alone, many, 9000, 8, 12), planted);
    expect_same(reference, renders(view, adaptive, many, 10000, 8, 12), planted);
}

// The variance falls by a factor of 1.9, and one pair of eight renders tells it within a tenth.
TEST(AdaptiveGuide, GuidedBouncesLowerVariance) {
    const View view = lamp_in_a_corridor();
    EXPECT_GT(pixel_variance(view, no_bounces, 11000, 12) /
                  pixel_variance(view, bounces_alone, 12000, 12),
              1.4);
}

// Passes count alike from the first choice on, however many photons the noise asked for.
TEST(AdaptiveGuide, SameExpectationWithPhotonsByTheNoise) {
    const View view = lamp_and_mirror();
    const auto by_noise = [](Settings& s) {
        adaptive(s);
        s.photons_per_pass = 0;
    };
    expect_same(renders(view, plain, seeds(), 1000),
                renders(view, by_noise, statistics::sized(6u, 8u), 11000, 8, 14),
                statistics::sized(0.07, 0.05));
}

TEST(AdaptiveGuide, SunOverAWideGround) {
    const View view = wide_ground();
    // Few photons are seen: within a narrower radius too few to tell.
    expect_same(renders(view, widely(plain), statistics::sized(20u, 40u), 5000, 8, 12),
                renders(view, widely(adaptive), statistics::sized(8u, 12u), 6000, 8, 12));
    EXPECT_GT(pixel_variance(view, plain, 7000, 24) / pixel_variance(view, adaptive, 8000, 24), 3);
}

TEST(AdaptiveGuide, GuidedBouncesGiveTheSameBitsForAnyNumberOfThreads) {
    const View view = lamp_in_a_corridor();
    Settings settings = mock::small_settings(13, 40000);
    settings.direct_light_sampling = false;
    adaptive(settings);
    settings.guide_survival = false;  // needs longer here until tables pay
    const auto rendering_with = [&](unsigned threads) {
        return concurrency::run_on(threads, [&] {
            return mock::render(view.scene, view.camera, kWidth, kHeight, settings, 12);
        });
    };
    const auto one = rendering_with(1);
    EXPECT_GT(one.statistics.bounce_tables, 0u);
    EXPECT_GT(one.statistics.guided_bounces, 0u);
    EXPECT_EQ(one.film.image(), rendering_with(2).film.image());
    EXPECT_EQ(one.film.image(), rendering_with(7).film.image());
}

/// Directions are alike in a closed box that shines everywhere: nothing is guided there.
TEST(AdaptiveGuide, NoTablesOfDirectionsWhereTheyDoNotPay) {
    mock::Scene scene;
    mock::Surface surface;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    scene.finish();
    Settings settings = mock::small_settings(14, 40000);
    adaptive(settings);
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    const auto s = mock::render(scene, camera, kWidth, kHeight, settings, 12).statistics;
    EXPECT_LT(double(s.guided_bounces), 0.02 * double(s.bounces));
}

TEST(AdaptiveGuide, StatisticsNameWhatItGains) {
    const View view = wide_ground();
    Settings settings = mock::small_settings(9, 20000);
    settings.direct_light_sampling = false;
    adaptive(settings);
    const auto s = mock::render(view.scene, view.camera, kWidth, kHeight, settings, 8).statistics;
    EXPECT_GT(s.emission_gain, 5);
    EXPECT_GT(s.score_times_cost, 0);
    EXPECT_GT(s.pruned_paths, 0u);
    EXPECT_GT(s.guide_nodes, 1u);
    EXPECT_LT(s.guide_bytes, 16u << 20);
}

}  // namespace
}  // namespace aips::adaptive_guide_test
