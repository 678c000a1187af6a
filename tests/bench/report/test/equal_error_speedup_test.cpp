// Protects equal-error speed-ups: exact on power laws, and bounds instead of extrapolation.
#include "equal_error_speedup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bench::test::equal_error_speedup_test {
namespace {

std::vector<CurvePoint> power_law(double factor) {
    std::vector<CurvePoint> curve;
    for (const double t : {0.5, 1.3, 2.0, 4.0, 9.0})
        curve.push_back({t, factor * std::pow(t, -0.8)});
    return curve;
}

TEST(EqualErrorSpeedup, PowerLawsAreExact) {
    // factor t^-0.8 = b 3^-0.8 at t = 3 (factor / b)^(1 / 0.8).
    const auto speedup = equal_error_speedup(power_law(0.5), power_law(1), 3).value();
    EXPECT_NEAR(speedup.factor, std::pow(2, 1 / 0.8), 1e-12);
    EXPECT_EQ(speedup.bound, Bound::None);
    EXPECT_NEAR(equal_error_speedup(power_law(1), power_law(1), 3).value().factor, 1, 1e-12);
}

TEST(EqualErrorSpeedup, NothingIsExtrapolated) {
    const auto never = equal_error_speedup(power_law(10), power_law(1), 3).value();
    EXPECT_EQ(never.bound, Bound::AtMost);
    EXPECT_NEAR(never.factor, 3.0 / 9, 1e-12);
    const auto at_once = equal_error_speedup(power_law(0.01), power_law(1), 3).value();
    EXPECT_EQ(at_once.bound, Bound::AtLeast);
    EXPECT_NEAR(at_once.factor, 3.0 / 0.5, 1e-12);
    EXPECT_FALSE(equal_error_speedup(power_law(1), power_law(1), 10));
    EXPECT_FALSE(equal_error_speedup({}, power_law(1), 3));
}

TEST(EqualErrorSpeedup, MeanIsGeometricAndBoundsStayBounds) {
    const auto mean = mean_speedup({{2}, {8}}).value();
    EXPECT_NEAR(mean.factor, 4, 1e-12);
    EXPECT_LT(mean.low.value(), 2);
    EXPECT_GT(mean.high.value(), 8);
    const auto bounded = mean_speedup({{2}, {8, Bound::AtLeast}}).value();
    EXPECT_EQ(bounded.bound, Bound::AtLeast);
    EXPECT_NEAR(bounded.low.value(), mean.low.value(), 1e-12);
    EXPECT_FALSE(bounded.high);
    EXPECT_FALSE(mean_speedup({{2, Bound::AtMost}, {8, Bound::AtLeast}}));
    EXPECT_FALSE(mean_speedup({}));
}

}  // namespace
}  // namespace bench::test::equal_error_speedup_test
