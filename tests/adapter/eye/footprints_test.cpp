// Protects radii from the few pixels that see the horizon: they count, but for no more than eight
// medians each.
#include "eye/footprints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace footprints_test {
namespace {

using aips::bounded_footprint_sum;

TEST(Footprints, AreSummedWhereNoneIsFarBeyondTheOthers) {
    std::vector<float> footprints{4, 1, 2, 7.5f, 3};
    EXPECT_DOUBLE_EQ(bounded_footprint_sum(footprints), 17.5);
    EXPECT_EQ(bounded_footprint_sum({}), 0);
}

TEST(Footprints, OfTheHorizonCountAsEightMedians) {
    std::vector<float> footprints(99, 1.0f);
    footprints.push_back(1e9f);
    EXPECT_DOUBLE_EQ(bounded_footprint_sum(footprints), 99 + 8);
}

TEST(Footprints, ThatAreNoNumbersCountForNothing) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    std::vector<float> footprints{kNaN, 1, kInfinity, 2, kNaN, 3};
    EXPECT_DOUBLE_EQ(bounded_footprint_sum(footprints), 6);
}

TEST(Footprints, OfCamerasWithoutAnyForMostPixelsAreNotBounded) {
    std::vector<float> footprints{0, 0, 0, 5, 0};
    EXPECT_DOUBLE_EQ(bounded_footprint_sum(footprints), 5);
}

TEST(Footprints, OfManyAreBoundedByTheirMedian) {
    std::vector<float> footprints(70001);
    for (std::size_t i = 0; i < footprints.size(); ++i)
        footprints[i] = 1e-3f * float(i * i % 100003) * float(i % 7);
    std::vector<float> sorted(footprints);
    std::ranges::sort(sorted);
    const float most = 8 * sorted[sorted.size() / 2];
    double sum = 0;
    for (const float footprint : footprints)
        sum += double(std::min(footprint, most));
    EXPECT_NEAR(bounded_footprint_sum(footprints), sum, 1e-12 * sum);
}

}  // namespace
}  // namespace footprints_test
