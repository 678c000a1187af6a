// Protects the bias that a radius may claim: factors for bias with radius and radius^2, and that a
// claim takes away what it was measured to be and no more.
#include "claimed_bias.h"

#include <gtest/gtest.h>

namespace bench::test::claimed_bias_test {
namespace {

TEST(ClaimedBias, FactorsExtrapolateBothPowersOfTheRadius) {
    const double r = 2, s = 1, q = 0.3;
    const BiasFactors factors = bias_factors(r, s, {q * q, q});
    // Bias 5 r^2: from what is seen between r and s follows that between r and the references.
    EXPECT_NEAR(factors.quadratic * 5 * (r * r - s * s), 5 * (r * r - q * q), 1e-12);
    EXPECT_NEAR(factors.linear * 5 * (r - s), 5 * (r - q), 1e-12);
    EXPECT_NEAR(bias_factors(r, s, {}).quadratic, 4.0 / 3, 1e-12);
}

/// Two seeds, three blocks, whose truth is 1, 2, 4.
statistics::BlockMeans blocks(const std::vector<double>& bias) {
    statistics::BlockMeans means{{1, 2, 4}, {1, 2, 4}};
    for (auto& seed : means) {
        for (std::size_t k = 0; k < 3; ++k)
            seed[k] += bias[k];
    }
    return means;
}

TEST(ClaimedBias, TakesAwayBiasBetweenTheTwoPowersAndNoMore) {
    // At radius 2: quadratic -0.4 in block 0, linear -0.4 in block 1, none in block 2.
    const BiasClaim claim{blocks({-0.4, -0.4, 0}), blocks({-0.1, -0.2, 0}), bias_factors(2, 1, {})};
    const auto exact = without_bias(blocks({-0.4, -0.4, 0}), claim, {1, 2, 4});
    EXPECT_NEAR(exact[0][0], 1, 1e-12);
    EXPECT_NEAR(exact[1][1], 2, 1e-12);
    EXPECT_NEAR(exact[0][2], 4, 1e-12);
    // Beyond the claim something is left: more than linear, less than quadratic, and of the other
    // sign, where the least claim is still taken away.
    const auto beyond = without_bias(blocks({-0.7, -0.1, 0.1}), claim, {1, 2, 4});
    EXPECT_NEAR(beyond[0][0], 1 - 0.7 + 0.6, 1e-12);
    EXPECT_NEAR(beyond[0][1], 2 - 0.1 + 0.2 * 4 / 3, 1e-12);
    EXPECT_NEAR(beyond[0][2], 4.1, 1e-12);
}

TEST(ClaimedBias, TheClaimsOwnNoiseStaysInTheSpread) {
    BiasClaim claim{blocks({0, 0, 0}), blocks({0, 0, 0}), bias_factors(2, 1, {})};
    claim.at_radius[0][0] += 0.3;
    claim.at_radius[1][0] -= 0.3;
    const auto corrected = without_bias(blocks({0, 0, 0}), claim, {1, 2, 4});
    EXPECT_NEAR(corrected[1][0] - corrected[0][0], 2 * 0.3 * 4 / 3, 1e-12);
}

}  // namespace
}  // namespace bench::test::claimed_bias_test
