// Protects the choice of mixture shares: what a share is thought to be worth is what it is worth,
// whichever mixture the samples came from, and no table is used that does not pay.
#include "aips/core/tables/mixture_moments.h"

#include <gtest/gtest.h>

#include <array>

#include "aips/core/sampling/random.h"

namespace aips::mixture_moments_test {
namespace {

constexpr std::size_t kCells = 4;
using Cells = std::array<double, kCells>;

/// A sum over four cells of a square, each of area 1/4: what a direction in each is worth and
/// costs, the plain density (uniform) and the table's.
constexpr Cells kPart{0.2, 1, 3, 0.5}, kCost{1, 2, 5, 3}, kTable{0.3, 0.9, 2.4, 0.4};

double mixed(std::size_t cell, double share) {
    return (1 - share) + share * kTable[cell];
}

/// Closed form, relative to no table.
double moment_ratio(double share) {
    double with = 0, without = 0;
    for (std::size_t i = 0; i < kCells; ++i) {
        with += kPart[i] * kPart[i] / mixed(i, share);
        without += kPart[i] * kPart[i];
    }
    return with / without;
}
double cost_ratio(double share) {
    double with = 0, without = 0;
    for (std::size_t i = 0; i < kCells; ++i) {
        with += kCost[i] * mixed(i, share);
        without += kCost[i];
    }
    return with / without;
}

/// Directions drawn from the mixture with `share`. Scores vary: 0 or twice as much.
MixtureMoments measured(double share, int samples, std::uint64_t seed) {
    MixtureMoments moments;
    RandomStream random(seed, 0, 0, RandomDomain::Guide);
    for (int n = 0; n < samples; ++n) {
        double u = 4 * double(random.next());
        std::size_t cell = 0;
        while (cell + 1 < kCells && u >= mixed(cell, share))
            u -= mixed(cell++, share);
        const double f = kPart[cell] / mixed(cell, share);
        const double score = random.next() < 0.5f ? 0 : 2 * f * f;
        moments.add(score, kCost[cell], {mixed(cell, share), 1, kTable[cell]});
    }
    return moments;
}

// 200 000 samples whose terms vary by about their mean: 1 % is four standard errors and more.
TEST(MixtureMoments, EqualTheClosedFormWhicheverMixtureWasDrawn) {
    for (const double drawn : {0.0, 0.5, 0.75}) {
        const MixtureMoments moments = measured(drawn, 200000, 1 + std::uint64_t(8 * drawn));
        for (std::size_t i = 0; i < kTableShares.size(); ++i) {
            const double share = kTableShares[i];
            EXPECT_NEAR(moments.moment_ratio(i), moment_ratio(share), 0.01 * moment_ratio(share));
            EXPECT_NEAR(moments.cost_ratio(i, 0), cost_ratio(share), 0.01 * cost_ratio(share));
        }
    }
}

TEST(MixtureMoments, EffectiveCountIsKishs) {
    MixtureMoments moments;
    EXPECT_EQ(moments.effective_count(), 0);
    for (int i = 0; i < 10; ++i)
        moments.add(i < 5 ? 2 : 0, 1, {1, 1, 1});
    EXPECT_DOUBLE_EQ(moments.effective_count(), 5);
    EXPECT_DOUBLE_EQ(moments.count(), 10);
    moments.scale(0.5);
    EXPECT_DOUBLE_EQ(moments.effective_count(), 2.5);
}

// A direction that only the table draws carries no light: it tells nothing of how to draw light.
TEST(MixtureMoments, DirectionsWithoutAPlainDensityAreLeftOut) {
    MixtureMoments moments;
    moments.add(0, 5, {0.4, 0, 1});
    EXPECT_EQ(moments.count(), 0);
}

std::size_t best_by_closed_form(double table_cost) {
    double mean_cost = 0;
    for (const double cost : kCost)
        mean_cost += cost / kCells;
    std::size_t best = 0;
    double least = 1;
    for (std::size_t i = 1; i < kTableShares.size(); ++i) {
        const double share = kTableShares[i];
        const double product = moment_ratio(share) * (cost_ratio(share) + table_cost / mean_cost);
        if (product < least) {
            least = product;
            best = i;
        }
    }
    return best;
}

TEST(ShareChoice, IsTheClosedFormsBest) {
    const MixtureMoments moments = measured(0.25, 100000, 5);
    ShareSettings settings;
    settings.gain = 1;
    for (const double table_cost : {0.0, 0.3, 0.8, 5.0}) {
        settings.table_cost = table_cost;
        EXPECT_EQ(choose_share(moments, moments, 0, settings), best_by_closed_form(table_cost))
            << table_cost;
    }
    EXPECT_GT(best_by_closed_form(0), 0u);
    EXPECT_EQ(best_by_closed_form(5), 0u);
}

// Off below the gain asked for; on, it stays as long as anything is gained.
TEST(ShareChoice, ComesIntoUseWithAMargin) {
    const MixtureMoments moments = measured(0, 100000, 6);
    ShareSettings settings;
    settings.gain = 2;
    EXPECT_EQ(choose_share(moments, moments, 0, settings), 0u);
    EXPECT_GT(choose_share(moments, moments, 1, settings), 0u);
    settings.gain = 1.05;
    EXPECT_GT(choose_share(moments, moments, 0, settings), 0u);
}

TEST(ShareChoice, FollowsAllPlacesWhereLittleIsKnown) {
    const MixtureMoments good = measured(0, 100000, 7);
    MixtureMoments bad;  // the table avoids what is worth something
    for (int i = 0; i < 20000; ++i)
        bad.add(1, 1, {1, 1, i % 10 == 0 ? 0.1 : 0.2});
    ShareSettings settings;
    settings.table_cost = 0;
    EXPECT_GT(choose_share({}, good, 0, settings), 0u);
    EXPECT_EQ(choose_share({}, bad, 0, settings), 0u);
    EXPECT_GT(choose_share(good, bad, 0, settings), 0u);
    EXPECT_EQ(choose_share(bad, good, 0, settings), 0u);
    EXPECT_EQ(choose_share({}, {}, 0, settings), 0u);
}

}  // namespace
}  // namespace aips::mixture_moments_test
