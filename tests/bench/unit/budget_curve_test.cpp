// Protects the error at a budget: exact where error goes with a power of time, never extrapolated.
#include "budget_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bench::test::budget_curve_test {
namespace {

TEST(BudgetCurve, PowerLawsAreExact) {
    std::vector<CurvePoint> curve;
    for (const double t : {0.7, 2.1, 9.0, 23.0})
        curve.push_back({t, 3 * std::pow(t, -0.8)});
    for (const double t : {0.7, 1.0, 5.0, 9.0, 20.0, 23.0})
        EXPECT_NEAR(error_at(curve, t).value(), 3 * std::pow(t, -0.8), 1e-12);
}

TEST(BudgetCurve, NothingOutsideTheSnapshots) {
    const std::vector<CurvePoint> curve{{1, 4}, {2, 2}};
    EXPECT_FALSE(error_at(curve, 0.99));
    EXPECT_FALSE(error_at(curve, 2.01));
    EXPECT_FALSE(error_at({}, 1));
}

TEST(BudgetCurve, ErrorsThatAreNotPositiveAreInterpolatedInLogTimeAlone) {
    const std::vector<CurvePoint> curve{{1, 2}, {4, -2}};
    EXPECT_NEAR(error_at(curve, 2).value(), 0, 1e-12);
}

}  // namespace
}  // namespace bench::test::budget_curve_test
