// Protects fitted slopes: exact on power laws, least squares in logarithms otherwise.
#include "power_law_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bench::test::power_law_fit_test {
namespace {

TEST(PowerLawFit, PowerLawsAreExact) {
    std::vector<CurvePoint> curve;
    for (const double t : {0.7, 2.1, 9.0, 23.0})
        curve.push_back({t, 3 * std::pow(t, -0.8)});
    const auto law = fit_power_law(curve);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->slope, -0.8, 1e-12);
    EXPECT_NEAR(law->factor, 3, 1e-12);
}

TEST(PowerLawFit, LeastSquaresInLogarithms) {
    // log points (0, 1), (1, 0), (2, 2): slope = sum (x-1)(y-1) / sum (x-1)^2 = 1/2, and y(0) =
    // 1/2.
    const std::vector<CurvePoint> curve{
        {1, std::exp(1.0)}, {std::exp(1.0), 1}, {std::exp(2.0), std::exp(2.0)}};
    const auto law = fit_power_law(curve);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->slope, 0.5, 1e-12);
    EXPECT_NEAR(law->factor, std::exp(0.5), 1e-12);
}

TEST(PowerLawFit, ErrorsThatAreNotPositiveAreLeftOut) {
    const std::vector<CurvePoint> curve{{1, 4}, {1.5, -1}, {1.7, 0}, {2, 2}};
    EXPECT_NEAR(fit_power_law(curve).value().slope, -1, 1e-12);
}

TEST(PowerLawFit, NothingFromOneTime) {
    EXPECT_FALSE(fit_power_law({}));
    EXPECT_FALSE(fit_power_law(std::vector<CurvePoint>{{1, 4}}));
    EXPECT_FALSE(fit_power_law(std::vector<CurvePoint>{{2, 4}, {2, 5}}));
}

}  // namespace
}  // namespace bench::test::power_law_fit_test
