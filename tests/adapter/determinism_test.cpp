// Protects: the same bits for any number of threads, and different images for different seeds.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "render_mock.h"

namespace {

using namespace aips;

std::vector<Rgb> image_with(unsigned threads, GuideKind guide, std::uint64_t seed,
                            Mode mode = Mode::Progressive,
                            CriterionKind criterion = CriterionKind::Paper) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const mock::Scene scene = mock::lamp_box({}, mock::half_mirror());
    Settings settings = mock::small_settings(seed, 20000);
    settings.guide = guide;
    settings.mode = mode;
    settings.error_criterion = criterion;
    settings.alpha = 0.7;
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, 40, 30);
    return mock::render(scene, camera, 40, 30, settings, 3).film.image();
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

TEST(DeterminismOfScores, SameBitsForAnyNumberOfThreadsWithTheImagesError) {
    const auto image = [](unsigned threads, CriterionKind criterion) {
        return image_with(threads, GuideKind::Paper, 11, Mode::Progressive, criterion);
    };
    const auto one = image(1, CriterionKind::Image);
    EXPECT_EQ(one, image(2, CriterionKind::Image));
    EXPECT_EQ(one, image(7, CriterionKind::Image));
    EXPECT_NE(one, image(2, CriterionKind::Paper));
}

INSTANTIATE_TEST_SUITE_P(Guides, Determinism,
                         testing::Values(GuideKind::None, GuideKind::Paper, GuideKind::Adaptive),
                         [](const auto& test) { return mock::name(test.param); });

}  // namespace
