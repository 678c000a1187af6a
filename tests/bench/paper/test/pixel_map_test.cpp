// Protects the numbers of Fig. 6 and 7 against closed forms.
#include "pixel_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bench::test::pixel_map_test {
namespace {

TEST(PixelMap, BlockMeansLeaveOutWhatFillsNoBlock) {
    const PixelMap map{5, 3, {1, 2, 3, 4, 9, 5, 6, 7, 8, 9, 9, 9, 9, 9, 9}};
    EXPECT_EQ(block_means(map, 2), (std::vector<double>{3.5, 5.5}));
}

TEST(PixelMap, GradientOfARampIsItsSlopeUpToTheBorder) {
    PixelMap ramp{4, 3, {}};
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x)
            ramp.values.push_back(3 * x + 4 * y);
    }
    for (const double value : gradient_magnitude(ramp).values)
        EXPECT_DOUBLE_EQ(value, 5);
}

TEST(PixelMap, LargestPixelsAndTheirShare) {
    const PixelMap map{5, 1, {0, 6, 1, 2, 1}};
    const auto marked = largest_pixels(map, 0.4);
    EXPECT_EQ(marked, (std::vector<bool>{false, true, false, true, false}));
    EXPECT_DOUBLE_EQ(*share_within(map, marked), 0.8);
    EXPECT_FALSE(share_within({2, 1, {0, 0}}, {true, false}));
}

TEST(PixelMap, RankCorrelation) {
    const std::vector<double> a{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(*rank_correlation(a, std::vector<double>{1, 10, 100, 1000}), 1);
    EXPECT_DOUBLE_EQ(*rank_correlation(a, std::vector<double>{4, 3, 2, 1}), -1);
    // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3.
    EXPECT_NEAR(*rank_correlation(a, std::vector<double>{1, 2, 2, 3}), 4.5 / std::sqrt(5 * 4.5),
                1e-12);
    EXPECT_FALSE(rank_correlation(a, std::vector<double>{7, 7, 7, 7}));
    EXPECT_FALSE(rank_correlation(std::vector<double>{1, 2}, std::vector<double>{1, 2}));
}

TEST(PixelMap, UnevennessAndDistance) {
    EXPECT_DOUBLE_EQ(*unevenness(std::vector<double>{2, 2, 2}), 0);
    EXPECT_DOUBLE_EQ(*unevenness(std::vector<double>{1, 3}), 0.5);
    EXPECT_FALSE(unevenness(std::vector<double>{0, 0}));
    const std::vector<double> a{1, 1, 0, 0};
    EXPECT_DOUBLE_EQ(*distribution_distance(a, std::vector<double>{5, 5, 0, 0}), 0);
    EXPECT_DOUBLE_EQ(*distribution_distance(a, std::vector<double>{0, 0, 1, 1}), 1);
    EXPECT_DOUBLE_EQ(*distribution_distance(a, std::vector<double>{1, 0, 1, 0}), 0.5);
    EXPECT_FALSE(distribution_distance(a, std::vector<double>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace bench::test::pixel_map_test
