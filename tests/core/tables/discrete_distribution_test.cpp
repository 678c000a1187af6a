// Protects choices by weight (lights): exact probabilities, nothing impossible drawn, bad weights.
#include "aips/core/tables/discrete_distribution.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"
#include "chi_square.h"

namespace aips::discrete_distribution_test {
namespace {

using Weights = std::vector<float>;
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(DiscreteDistribution, EmptyWithoutPositiveWeights) {
    EXPECT_TRUE(DiscreteDistribution().empty());
    EXPECT_TRUE(DiscreteDistribution(Weights{}).empty());
    const DiscreteDistribution zeros(Weights{0, -1, kNan});
    EXPECT_TRUE(zeros.empty());
    EXPECT_EQ(zeros.pdf(1), 0.0f);
}

TEST(DiscreteDistribution, ProbabilitiesFollowTheWeights) {
    const DiscreteDistribution d(Weights{1, 0, 3, -5, 4});
    EXPECT_EQ(d.total(), 8);
    EXPECT_NEAR(d.pdf(0), 0.125f, 1e-6);
    EXPECT_EQ(d.pdf(1), 0.0f);
    EXPECT_NEAR(d.pdf(2), 0.375f, 1e-6);
    EXPECT_EQ(d.pdf(3), 0.0f);
    EXPECT_NEAR(d.pdf(4), 0.5f, 1e-6);
}

TEST(DiscreteDistribution, DrawsByItsPdfAndStretchesTheRest) {
    const DiscreteDistribution d(Weights{1, 0, 3, 2, 0, 10});
    constexpr int kDraws = 100000;
    constexpr std::size_t kParts = 4;
    std::vector<double> observed(d.size() * kParts), expected(d.size() * kParts);
    RandomStream random(1, 0, 0, RandomDomain::Guide);
    for (int i = 0; i < kDraws; ++i) {
        const DiscreteSample s = d.sample(random.next());
        ASSERT_EQ(s.pdf, d.pdf(s.index));
        ASSERT_GE(s.u, 0.0f);
        ASSERT_LT(s.u, 1.0f);
        ++observed[s.index * kParts + std::size_t(s.u * kParts)];
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        expected[i] = double(d.pdf(i / kParts)) * kDraws / kParts;
    }
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, 1e-4) << result.describe;
}

// With 2^24 equally likely random numbers each alternative is drawn exactly pdf * 2^24 times: the
// weakest light is neither lost nor too bright.
TEST(DiscreteDistribution, ProbabilitiesAreExactOverAllRandomNumbers) {
    const DiscreteDistribution d(Weights{1e-30f, 1, 0, 1e-12f, 1e6f, 1e-42f});
    std::vector<double> count(d.size());
    for (std::uint32_t k = 0; k < (1u << 24); ++k)
        ++count[d.sample(float(k) * 0x1p-24f).index];
    for (std::size_t i = 0; i < d.size(); ++i)
        EXPECT_EQ(count[i], double(d.pdf(i)) * 0x1p24) << i;
    EXPECT_GT(d.pdf(0), 0.0f);
    EXPECT_EQ(d.pdf(2), 0.0f);
    EXPECT_GT(d.pdf(5), 0.0f);
}

TEST(DiscreteDistribution, SurvivesExtremeWeightsAndNumbers) {
    const DiscreteDistribution d(Weights{kInf, 1, std::numeric_limits<float>::max(), 0});
    EXPECT_NEAR(d.pdf(0), 0.5f, 1e-6);
    EXPECT_LT(d.sample(1.0f).index, 3u);
    EXPECT_EQ(d.sample(kNan).index, 0u);
    EXPECT_EQ(d.sample(-1.0f).index, 0u);
}

TEST(DiscreteDistribution, RefusesMoreThanItCanResolve) {
    EXPECT_THROW(DiscreteDistribution(Weights((1u << 22) + 1, 1.0f)), std::length_error);
}

}  // namespace
}  // namespace aips::discrete_distribution_test
