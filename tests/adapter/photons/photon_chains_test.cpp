// Protects photonsampler=amc: Markov chains change the variance of photons, never their
// expectation; they are the same for any number of threads, of bounded memory, and harmless where
// no photon path is visible.
#include "photons/photon_chains.h"

#include <gtest/gtest.h>

#include "block_test.h"
#include "plan/flat_memory.h"
#include "render_mock.h"
#include "run_on_threads.h"
#include "test_form.h"

namespace aips::photon_chains_test {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 24;

using mock::View;

View box_view() {
    return mock::half_mirror_view(kWidth, kHeight);
}

View wide_view(float half) {
    return mock::wide_view(half, kWidth, kHeight);
}

Settings chain_settings(std::uint64_t seed, std::uint32_t photons, PhotonSampler sampler,
                        double start_radius = 3) {
    // alpha 1 keeps the radius, and a fixed start radius is the same for both: equal bias.
    Settings settings = mock::small_settings(seed, photons);
    settings.photon_sampler = sampler;
    settings.start_radius = start_radius;
    settings.direct_light_sampling = false;  // all light by photons
    return settings;
}

/// Block means of renders with different seeds.
statistics::BlockMeans renders(const View& view, PhotonSampler sampler, unsigned seeds,
                               std::uint64_t first_seed, std::uint32_t photons,
                               std::uint32_t passes) {
    statistics::BlockMeans means;
    for (unsigned s = 0; s < seeds; ++s) {
        const Settings settings = chain_settings(first_seed + s, photons, sampler);
        const auto r = mock::render(view.scene, view.camera, kWidth, kHeight, settings, passes);
        means.push_back(statistics::block_means(mock::luminances(r.film), kWidth, kHeight, 8));
    }
    return means;
}

/// 13 tests per comparison at a family-wise significance of 1 %, fixed seeds. A planted bias of
/// `planted` must be found.
void expect_same(const View& view, unsigned seeds, std::uint32_t photons, std::uint32_t passes,
                 double planted) {
    const auto plain = renders(view, PhotonSampler::Sequence, seeds, 1000, photons, passes);
    const auto chains = renders(view, PhotonSampler::AdaptiveChains, seeds, 2000, photons, passes);
    const auto same = statistics::compare(plain, chains, 0.01);
    std::cout << same.describe() << "\n";
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, planted) << same.describe();
    EXPECT_TRUE(
        statistics::compare(plain, statistics::scaled(chains, 1 + planted), 0.01).differs());
}

TEST(PhotonChains, SameExpectationInABox) {
    expect_same(box_view(), statistics::sized(12u, 24u), 8000, 8, statistics::sized(0.03, 0.02));
}

/// A bounce at the sheet draws five numbers, or with a specular lobe six. Handed out again at the
/// next bounce they made the mean 5 % too low.
TEST(PhotonChains, SameExpectationOnBothSidesOfATiltedSheet) {
    for (const bool shiny : {false, true})
        expect_same(mock::divided_view(kWidth, kHeight, mock::sheet(shiny), 0),
                    statistics::sized(14u, 24u), 8000, 8, statistics::sized(0.06, 0.04));
}

/// Few paths a pass: some measured paths are visible, and the chains begin anew in each of 60
/// passes per seed. A start-up bias, or one of the visible share, would show.
TEST(PhotonChains, SameExpectationWhereFewPathsAreVisible) {
    expect_same(wide_view(2), statistics::sized(40u, 120u), 500, 60, statistics::sized(0.1, 0.05));
}

/// Mean over pixels of the variance over seeds.
double pixel_variance(const View& view, PhotonSampler sampler, unsigned seeds) {
    statistics::BlockMeans pixels;
    for (unsigned s = 0; s < seeds; ++s) {
        const Settings settings = chain_settings(3000 + s, 40000, sampler, 0.5);
        pixels.push_back(mock::luminances(
            mock::render(view.scene, view.camera, kWidth, kHeight, settings, 6).film));
    }
    return statistics::mean_variance(pixels);
}

/// What the method is for.
TEST(PhotonChains, LowerVarianceWhereFewPathsAreVisible) {
    const View view = wide_view(10);
    const double ratio = pixel_variance(view, PhotonSampler::Sequence, 12) /
                         pixel_variance(view, PhotonSampler::AdaptiveChains, 12);
    std::cout << "variance of plain photons over that of chains: " << ratio << "\n";
    EXPECT_GT(ratio, 4);
}

/// Lamp and camera in rooms of their own: each path misses, all are counted, the image is black.
TEST(PhotonChains, NothingVisibleEndsCleanly) {
    mock::Scene scene;
    mock::Surface wall;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    mock::Surface box = wall;
    scene.add_box({4, -1, -1}, {6, 1, 1}, box);
    scene.add_point_light({5, 0, 0}, {1, 1, 1});
    scene.finish();
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    const auto settings = chain_settings(5, 5000, PhotonSampler::AdaptiveChains);
    const auto r = mock::render(scene, camera, kWidth, kHeight, settings, 3);
    EXPECT_EQ(r.film.mean(), 0);
    EXPECT_EQ(r.statistics.photon_paths, 15000u);
    EXPECT_EQ(r.statistics.visible_paths, 0u);
    EXPECT_EQ(r.statistics.photons, 0u);
    EXPECT_EQ(r.statistics.refused.size(), 0u);
}

/// Budgets that do not divide by the number of chains, or are below it.
TEST(PhotonChains, TracesExactlyThePathsAskedFor) {
    const View view = box_view();
    for (const std::uint32_t photons : {1u, 63u, 65u, 1000u, 16385u}) {
        const auto settings = chain_settings(6, photons, PhotonSampler::AdaptiveChains);
        const auto r = mock::render(view.scene, view.camera, kWidth, kHeight, settings, 3);
        EXPECT_EQ(r.statistics.photon_paths, 3 * photons);
        EXPECT_TRUE(std::isfinite(r.film.mean()));
        // Each chain measures half of its paths, rounded up.
        EXPECT_GE(r.statistics.measured_paths, 3 * (photons + 1) / 2 - 3);
        EXPECT_LE(r.statistics.measured_paths, 3 * (photons / 2 + chain_count(photons)));
    }
}

TEST(PhotonChains, SameBitsForAnyNumberOfThreads) {
    const View view = wide_view(10);
    const auto image_with = [&](unsigned threads) {
        const auto settings = chain_settings(7, 20000, PhotonSampler::AdaptiveChains);
        return concurrency::run_on(threads, [&] {
            return mock::render(view.scene, view.camera, kWidth, kHeight, settings, 3).film.image();
        });
    };
    const auto one = image_with(1);
    EXPECT_EQ(one, image_with(2));
    EXPECT_EQ(one, image_with(7));
}

TEST(PhotonChains, MemoryStaysBelowTheBoundAndFlat) {
    const View view = wide_view(10);
    const auto settings = chain_settings(8, 20000, PhotonSampler::AdaptiveChains);
    mock::expect_flat_memory(view.scene, view.camera, kWidth, kHeight, settings);
}

/// The mutation size leaves its start and settles where about the wanted share is accepted.
TEST(PhotonChains, MutationSizeAdaptsToTheScene) {
    const View view = wide_view(10);
    const auto settings = chain_settings(9, 40000, PhotonSampler::AdaptiveChains);
    const auto wide = mock::render(view.scene, view.camera, kWidth, kHeight, settings, 8);
    EXPECT_LT(wide.statistics.mutation_size, 0.5);
    EXPECT_GE(wide.statistics.mutation_size, MutationSize::kFloor);
    const View box = box_view();
    const auto well_lit = mock::render(box.scene, box.camera, kWidth, kHeight, settings, 8);
    EXPECT_GT(well_lit.statistics.mutation_size, 1);
}

TEST(PhotonChains, ContradictAGuide) {
    Settings settings = chain_settings(1, 1000, PhotonSampler::AdaptiveChains);
    EXPECT_NO_THROW(validate(settings));
    settings.guide = GuideKind::Paper;
    EXPECT_THROW(validate(settings), std::invalid_argument);
}

}  // namespace
}  // namespace aips::photon_chains_test
