// Protects the test of the tests: chi-square against published quantiles, and its power.
#include "chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace aips::test::chi_square_test {
namespace {

TEST(ChiSquare, TailMatchesPublishedQuantiles) {
    EXPECT_NEAR(chi_square_tail(3.841459, 1), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(18.307038, 10), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(149.449253, 100), 0.001, 1e-6);
    EXPECT_EQ(chi_square_tail(0, 5), 1);
}

TEST(ChiSquare, FindsAWrongDensityAndAnImpossibleCell) {
    const std::vector<double> expected(10, 1000);
    std::vector<double> observed(10, 1000);
    EXPECT_EQ(chi_square(observed, expected).p_value, 1);
    observed[0] = 1200;
    observed[1] = 800;
    EXPECT_LT(chi_square(observed, expected).p_value, 1e-6);
    EXPECT_EQ(chi_square(std::vector<double>{5, 1}, std::vector<double>{6, 0}).p_value, 0);
}

TEST(ChiSquare, PoolsRareCells) {
    const auto result =
        chi_square(std::vector<double>{1, 2, 0, 97}, std::vector<double>{2, 2, 2, 94});
    EXPECT_EQ(result.degrees, 1);
}

TEST(ChiSquare, SidakSharesTheSignificance) {
    EXPECT_NEAR(1 - std::pow(1 - sidak(0.01, 50), 50), 0.01, 1e-12);
}

}  // namespace
}  // namespace aips::test::chi_square_test
