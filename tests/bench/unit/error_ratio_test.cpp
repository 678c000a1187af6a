// Protects ratios: their value, their interval's coverage, and what happens to missing errors.
#include "error_ratio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace bench::test::error_ratio_test {
namespace {

using Errors = std::vector<std::optional<double>>;

TEST(ErrorRatio, IsTheGeometricMeanOverSeeds) {
    const ErrorRatio ratio = error_ratio(Errors{1.0, 8.0}, Errors{2.0, 4.0});
    EXPECT_NEAR(ratio.ratio.value(), 1, 1e-12);
    EXPECT_EQ(ratio.used, 2u);
    // Log ratios -ln 2 and ln 2: standard error ln 2, t(0.975, 1) = 12.706.
    EXPECT_NEAR(std::log(ratio.high.value()), 12.7062 * std::log(2), 1e-3);
    EXPECT_NEAR(std::log(ratio.low.value()), -12.7062 * std::log(2), 1e-3);
}

TEST(ErrorRatio, MissingAndNotPositiveErrorsAreLeftOutAndCounted) {
    const ErrorRatio ratio = error_ratio(Errors{2.0, std::nullopt, -1.0, 2.0, 3.0},
                                         Errors{1.0, 1.0, 1.0, 0.0, std::nullopt});
    EXPECT_NEAR(ratio.ratio.value(), 2, 1e-12);
    EXPECT_EQ(ratio.used, 1u);
    EXPECT_EQ(ratio.left_out, 4u);
    EXPECT_FALSE(ratio.low);
    EXPECT_FALSE(error_ratio(Errors{std::nullopt}, Errors{1.0}).ratio);
}

TEST(ErrorRatio, IntervalCoversTheTruthAsOftenAsItSays) {
    // 2000 studies of 3 seeds: coverage 0.95 with standard deviation 0.0049; bounds of 4 of them.
    std::mt19937 random(11);
    std::lognormal_distribution<double> error(0, 0.3);
    int covered = 0;
    constexpr int kStudies = 2000;
    for (int study = 0; study < kStudies; ++study) {
        Errors errors, baseline;
        for (int seed = 0; seed < 3; ++seed) {
            errors.emplace_back(0.5 * error(random));
            baseline.emplace_back(error(random));
        }
        const ErrorRatio ratio = error_ratio(errors, baseline);
        covered += *ratio.low <= 0.5 && 0.5 <= *ratio.high;
    }
    EXPECT_NEAR(double(covered) / kStudies, 0.95, 4 * 0.0049);
}

}  // namespace
}  // namespace bench::test::error_ratio_test
