// Protects: the same bits for any number of threads, and different images for different seeds.
#include <gtest/gtest.h>

#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::determinism_test {
namespace {

std::vector<Rgb> image_with(unsigned threads, GuideKind guide, std::uint64_t seed,
                            Mode mode = Mode::Progressive,
                            CriterionKind criterion = CriterionKind::Paper) {
    const mock::Scene scene = mock::lamp_box({}, mock::half_mirror());
    Settings settings = mock::small_settings(seed, 20000);
    settings.guide = guide;
    settings.mode = mode;
    settings.error_criterion = criterion;
    settings.alpha = 0.7;
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 40, 30);
    return concurrency::run_on(
        threads, [&] { return mock::render(scene, camera, 40, 30, settings, 3).film.image(); });
}

class Determinism : public testing::TestWithParam<GuideKind> {};

TEST_P(Determinism, SameBitsForAnyNumberOfThreads) {
    const auto one = image_with(1, GetParam(), 11);
    EXPECT_EQ(one, image_with(2, GetParam(), 11));
    EXPECT_EQ(one, image_with(7, GetParam(), 11));
}

TEST_P(Determinism, SameBitsForAnyNumberOfThreadsWithARadiusPerPoint) {
    const auto one = image_with(1, GetParam(), 11, Mode::Ppm);
    EXPECT_EQ(one, image_with(2, GetParam(), 11, Mode::Ppm));
    EXPECT_EQ(one, image_with(7, GetParam(), 11, Mode::Ppm));
}

TEST_P(Determinism, SeedsDiffer) {
    EXPECT_NE(image_with(2, GetParam(), 11), image_with(2, GetParam(), 12));
}

/// With more eye paths and pixels than one job takes, and photons per pass that follow the noise.
mock::Rendering rendering_of_many_jobs(unsigned threads, GuideKind guide) {
    constexpr std::uint32_t kWidth = 128, kHeight = 96;
    const mock::View view = mock::half_mirror_view(kWidth, kHeight);
    Settings settings = mock::small_settings(13, 0);
    settings.guide = guide;
    // Where eye paths carry what they can, as few photons as at first may be the choice.
    settings.continue_eye_paths = guide != GuideKind::None;
    // One more than it takes to choose, with a guide and without.
    const std::uint32_t passes = 9;
    return concurrency::run_on(threads, [&] {
        return mock::render(view.scene, view.camera, kWidth, kHeight, settings, passes);
    });
}

TEST(DeterminismOfChoices, SameBitsForAnyNumberOfThreadsOfManyJobs) {
    for (const GuideKind guide : {GuideKind::None, GuideKind::Adaptive}) {
        const auto one = rendering_of_many_jobs(1, guide);
        EXPECT_NE(one.statistics.photon_paths,
                  one.statistics.passes * one.statistics.photons_per_pass)
            << "no choice was made";
        for (const unsigned threads : {2u, 7u}) {
            const auto many = rendering_of_many_jobs(threads, guide);
            EXPECT_EQ(one.film.image(), many.film.image());
            EXPECT_EQ(one.statistics.photons_per_pass, many.statistics.photons_per_pass);
        }
    }
}

/// A guide learns from one iteration while the next is traced: of many paths, after which
/// iterations are longer.
TEST(DeterminismOfLag, SameBitsForAnyNumberOfThreads) {
    const mock::View view = mock::half_mirror_view(40, 30);
    const auto image = [&](unsigned threads) {
        Settings settings = mock::small_settings(19, 300'000);
        settings.guide = GuideKind::Adaptive;
        return concurrency::run_on(threads, [&] {
            return mock::render(view.scene, view.camera, 40, 30, settings, 4).film.image();
        });
    };
    EXPECT_EQ(image(1), image(4));
}

TEST(DeterminismOfScores, SameBitsForAnyNumberOfThreadsWithTheImagesError) {
    const auto image = [](unsigned threads, CriterionKind criterion) {
        return image_with(threads, GuideKind::Paper, 11, Mode::Progressive, criterion);
    };
    const auto one = image(1, CriterionKind::Image);
    EXPECT_EQ(one, image(2, CriterionKind::Image));
    EXPECT_EQ(one, image(7, CriterionKind::Image));
    EXPECT_NE(one, image(2, CriterionKind::Paper));
}

TEST(DeterminismOfSwitches, SameBitsForAnyNumberOfThreadsAndAnImageForEach) {
    const mock::View view = mock::half_mirror_view(40, 30);
    const auto image = [&](unsigned threads, bool present_errors, bool direct_photons) {
        Settings settings = mock::small_settings(17, 20000);
        settings.guide = GuideKind::Paper;
        settings.present_errors = present_errors;
        settings.direct_photons = direct_photons;
        return concurrency::run_on(threads, [&] {
            return mock::render(view.scene, view.camera, 40, 30, settings, 2).film.image();
        });
    };
    std::vector<std::vector<Rgb>> images;
    for (const bool present : {true, false}) {
        for (const bool first : {true, false}) {
            images.push_back(image(1, present, first));
            for (const auto& other : std::span(images).first(images.size() - 1))
                EXPECT_NE(images.back(), other);
            EXPECT_EQ(images.back(), image(2, present, first));
            EXPECT_EQ(images.back(), image(7, present, first));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Guides, Determinism,
                         testing::Values(GuideKind::None, GuideKind::Paper, GuideKind::Adaptive),
                         [](const auto& test) { return mock::name(test.param); });

}  // namespace
}  // namespace aips::determinism_test
