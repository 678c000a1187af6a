// Protects the measure by which images are judged: a real difference must show, noise must not.
#include "block_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene_set.h"
#include "synthetic_image.h"

namespace conformance::block_comparison_test {
namespace {

TEST(BlockComparison, EqualImagesDoNotDiffer) {
    const Comparison found = compare(smooth_image(), smooth_image());
    EXPECT_EQ(found.luminance.median, 0);
    EXPECT_EQ(found.luminance.p95, 0);
    for (const double ratio : found.mean_ratio)
        EXPECT_DOUBLE_EQ(ratio, 1);
}

TEST(BlockComparison, ThreePercentIsAMissAndMeasuredAsSuch) {
    const Comparison found = compare(noisy(smooth_image(), 1.03, 0, 1), smooth_image());
    EXPECT_NEAR(found.luminance.median, 0.03, 1e-6);
    EXPECT_NEAR(found.luminance.p95, 0.03, 1e-6);
    EXPECT_NEAR(found.mean_ratio[2], 1.03, 1e-6);
    EXPECT_FALSE(is_below(found.luminance, limit_for("any")));
}

TEST(BlockComparison, NoiseThatBlocksAverageOutIsNoMiss) {
    // 7 % a pixel is 0.7 % a block of 100; the median of |normal| is 0.6745 sigma, p95 1.96.
    const Comparison found = compare(noisy(smooth_image(), 1, 0.07, 2), smooth_image());
    EXPECT_NEAR(found.luminance.median, 0.6745 * 0.007, 0.0012);
    EXPECT_NEAR(found.luminance.p95, 1.96 * 0.007, 0.003);
    EXPECT_TRUE(is_below(found.luminance, limit_for("any")));
}

TEST(BlockComparison, AFewWrongBlocksMissByThePercentileAlone) {
    render::Image image = smooth_image();
    // 8 of 108 blocks, wrong by 20 %.
    for (std::size_t y = 0; y < 10; ++y) {
        for (std::size_t i = 0; i < std::size_t(3 * 80); ++i)
            image.rgb[3 * y * image.width + i] *= 1.2f;
    }
    const Comparison found = compare(image, smooth_image());
    EXPECT_EQ(found.luminance.median, 0);
    EXPECT_NEAR(found.luminance.p95, 0.2, 1e-6);
}

TEST(BlockComparison, AWrongHueOfRightLuminanceShowsInTheChannels) {
    render::Image image = smooth_image();
    // Red up by 10 % (0.9 of it), green down by as much luminance.
    const double less = 0.2126 * 0.09 / 0.7152;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        image.rgb[i] *= 1.1f;
        image.rgb[i + 1] = float(double(image.rgb[i + 1]) * (1 - less));
    }
    const Comparison found = compare(image, smooth_image());
    EXPECT_LT(found.luminance.p95, 1e-5);
    EXPECT_NEAR(found.channels[0].median, 0.1, 1e-5);
    EXPECT_NEAR(found.mean_ratio[1], 1 - less, 1e-5);
}

TEST(BlockComparison, LightWhereTheReferenceIsBlackCounts) {
    render::Image black = smooth_image(), image = black;
    for (std::size_t i = 0; i < black.rgb.size() / 2; ++i)
        black.rgb[i] = 0;
    EXPECT_GT(compare(image, black).luminance.p95, 1e3);
    EXPECT_EQ(compare(black, black).luminance.p95, 0);
}

TEST(BlockComparison, WhatIsNoNumberIsTheWorst) {
    render::Image image = smooth_image();
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(is_below(compare(image, smooth_image()).luminance, limit_for("any")));
    EXPECT_EQ(not_finite(image), image.rgb.size());
    image.rgb.assign(image.rgb.size(), -1.0f);
    EXPECT_EQ(negatives(image), image.rgb.size());
}

TEST(BlockComparison, ImagesOfDifferentSizesAreRefused) {
    render::Image small{10, 10, std::vector<float>(300, 1.0f)};
    EXPECT_THROW(compare(small, smooth_image()), std::invalid_argument);
    render::Image tiny{5, 5, std::vector<float>(75, 1.0f)};
    EXPECT_THROW(compare(tiny, tiny), std::invalid_argument);
}

/// The noise that two halves tell is the mean's true distance from the truth.
TEST(BlockComparison, NoiseOfTheMeanIsItsDistanceFromTheTruth) {
    const render::Image truth = smooth_image();
    Spread estimated, real;
    constexpr int kTimes = 40;
    for (int i = 0; i < kTimes; ++i) {
        const auto seed = 2 * std::uint64_t(i);
        const render::Image a = noisy(truth, 1, 0.1, 100 + seed),
                            b = noisy(truth, 1, 0.1, 101 + seed);
        const Spread noise = noise_of_mean(a, b), distance = compare(mean(a, b), truth).luminance;
        estimated.median += noise.median / kTimes, estimated.p95 += noise.p95 / kTimes;
        real.median += distance.median / kTimes, real.p95 += distance.p95 / kTimes;
    }
    EXPECT_NEAR(estimated.median, real.median, 0.05 * real.median);
    EXPECT_NEAR(estimated.p95, real.p95, 0.05 * real.p95);
    EXPECT_NEAR(real.median, 0.6745 * 0.1 / std::sqrt(200.0), 0.05 * real.median);
}

}  // namespace
}  // namespace conformance::block_comparison_test
