// Protects bias^2 and variance: a known bias and a known noise come out apart.
#include "seed_statistics.h"

#include <gtest/gtest.h>

#include <vector>

#include "synthetic_image.h"

namespace bench::test::seed_statistics_test {
namespace {

TEST(SeedStatistics, KnownBiasAndVarianceComeOutApart) {
    constexpr double kBias = 0.2, kDeviation = 0.5;
    std::mt19937 random(3);
    std::vector<Image> images;
    images.reserve(4);
    for (int seed = 0; seed < 4; ++seed)
        images.push_back(noisy_image(128, 128, 3 + kBias, kDeviation, random));
    const Image first = noisy_image(128, 128, 3, 0.1, random);
    const Image second = noisy_image(128, 128, 3, 0.1, random);
    const SeedStatistics statistics = seed_statistics(images, first, second);
    // 49152 samples: the standard deviations are 0.0009 and 0.0006; bounds of about 5 of them.
    EXPECT_NEAR(statistics.variance, kDeviation * kDeviation, 0.005);
    EXPECT_NEAR(statistics.bias2, kBias * kBias, 0.004);
    EXPECT_NEAR(statistics.rel_variance, kDeviation * kDeviation / 9, 0.001);
    EXPECT_NEAR(statistics.rel_bias2, kBias * kBias / 9, 0.001);
}

TEST(SeedStatistics, UnbiasedSeedsShowNoBias) {
    std::mt19937 random(4);
    std::vector<Image> images;
    images.reserve(2);
    for (int seed = 0; seed < 2; ++seed)
        images.push_back(noisy_image(128, 128, 3, 0.5, random));
    const Image truth = synthetic_image(128, 128, [](int, int) { return 3; });
    // The mean of two seeds is off by 0.125 in the square; none of it may count as bias.
    EXPECT_NEAR(seed_statistics(images, truth, truth).bias2, 0, 0.005);
}

TEST(SeedStatistics, OneSeedIsRefused) {
    const std::vector images{synthetic_image(4, 4, [](int, int) { return 1; })};
    EXPECT_THROW(seed_statistics(images, images[0], images[0]), std::invalid_argument);
}

}  // namespace
}  // namespace bench::test::seed_statistics_test
