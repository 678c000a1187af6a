// Protects the moves of Metropolis sampling: mutations are as likely as their reverse, stay in the
// unit interval, and start from what was accepted last.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "path/metropolis_chain.h"

namespace lxs::test::metropolis_mutation_test {
namespace {

double chi_square_p(double statistic, double degrees) {
    return cdf(complement(boost::math::chi_squared(degrees), statistic));
}

// Signed lengths are even in sign and log-uniform in size: P(d > x) = log(largest / x) /
// log(ratio). Chi-square over 2 x 16 equally likely cells, significance 1e-4 each, fixed seed. A
// mutation from 0.999 goes around the end.
TEST(MetropolisMutation, IsSymmetricAndExponential) {
    const MutationRange range{1.0 / 1024, 1.0 / 64};
    for (const float from : {0.5f, 0.0f, 0.999f}) {
        std::array<int, 32> counts{};
        constexpr int kDraws = 64000;
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const float to = mutate(from, RandomStream(3, 0, i).next(), range);
            ASSERT_GE(to, 0.0f);
            ASSERT_LT(to, 1.0f);
            double moved = double{to} - from;
            moved -= std::round(moved);
            // Rounding to float may lift a length over the bounds by one part in 10^4.
            const double share = std::log(range.largest / std::abs(moved)) /
                                 std::log(range.largest / range.smallest);
            const int cell = std::clamp(static_cast<int>(share * 16), 0, 15);
            ++counts[static_cast<std::size_t>(moved > 0 ? cell : 16 + cell)];
        }
        double statistic = 0;
        for (const int count : counts)
            statistic += std::pow(count - kDraws / 32.0, 2) / (kDraws / 32.0);
        EXPECT_GT(chi_square_p(statistic, 31), 1e-4) << "from " << from;
    }
}

TEST(MetropolisMutation, StaysBelowOne) {
    EXPECT_LT(mutate(0.0f, 0.5f, {1e-9, 1e-9}), 1.0f);
    EXPECT_GE(mutate(0.3f, 0.2f, {0.1, 70.0}), 0.0f);
}

std::array<float, 6> read(MetropolisCoordinates& coordinates) {
    std::array<float, 6> values;
    for (float& value : values)
        value = coordinates.next();
    return values;
}

TEST(MetropolisCoordinates, SmallMutationsStartFromWhatWasAcceptedLast) {
    MetropolisCoordinates coordinates({1e-4, 1e-3}, {1e-4, 1e-3});
    const auto near = [](const auto& a, const auto& b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double moved = double{a[i]} - b[i];
            if (std::abs(moved - std::round(moved)) > (i < 2 ? 1e-3 : 1.0 / 64) + 1e-6)
                return false;
        }
        return true;
    };
    coordinates.propose(RandomStream(1, 0, 0), true);
    const auto first = read(coordinates);
    coordinates.accept();
    coordinates.propose(RandomStream(1, 1, 0), true);
    EXPECT_FALSE(near(read(coordinates), first)) << "a large step draws anew";
    coordinates.propose(RandomStream(1, 2, 0), false);
    const auto third = read(coordinates);
    EXPECT_TRUE(near(third, first)) << "the large step was not accepted";
    EXPECT_NE(third, first);
    coordinates.accept();
    coordinates.propose(RandomStream(1, 3, 0), false);
    EXPECT_TRUE(near(read(coordinates), third));
}

TEST(MetropolisCoordinates, EndlessPathsAreServed) {
    MetropolisCoordinates coordinates({}, {});
    for (std::uint64_t i = 0; i < 3; ++i) {
        coordinates.propose(RandomStream(1, i, 0), i == 0);
        double sum = 0;
        for (std::size_t k = 0; k < 3 * MetropolisCoordinates::kMostStored; ++k)
            sum += coordinates.next();
        EXPECT_NEAR(sum / (3 * MetropolisCoordinates::kMostStored), 0.5, 0.05);
        coordinates.accept();
    }
}

}  // namespace
}  // namespace lxs::test::metropolis_mutation_test
