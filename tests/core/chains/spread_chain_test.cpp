// Protects chains that start at weighted paths: the share of visible paths times the mean over
// their states is the integral over the visible paths, from the first step on and where few are
// visible; pools draw in proportion to weights, thinned or not.
#include "aips/core/chains/spread_chain.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "aips/core/chains/start_pool.h"
#include "chi_square.h"

namespace aips::spread_chain_test {
namespace {

constexpr double kSignificance = 1e-4;

using Point = std::array<float, 2>;

/// Two islands in the square, 0.01 of it each: a box at the left, and a thin diagonal strip.
bool visible(const Point& p) {
    const bool box = p[0] < 0.1f && p[1] < 0.1f;
    const bool strip = p[0] >= 0.25f && p[0] < 0.75f && std::abs(p[1] - p[0]) < 0.01f;
    return box || strip;
}

double f(const Point& p) {
    return 1 + double(p[0]) * 3;
}
constexpr double kIntegral = 0.01 * (1 + 0.05 * 3) + 0.01 * 2.5;

/// Paths start four times as often in the left quarter of the square: w is 7/16 there and 7/4
/// elsewhere, so that the box is met four times as often as the strip.
constexpr double kLeftShare = 4.0 / 7;

struct Independent {
    std::vector<Coordinate> coordinates;
    Point point{};
    double weight = 1;

    Independent(std::uint64_t pass, std::uint64_t number) {
        RandomStream random(9, pass, number, RandomDomain::UniformPath);
        const double u = double(random.next());
        const bool left = u < kLeftShare;
        const double x =
            left ? u / kLeftShare / 4 : 0.25 + 0.75 * (u - kLeftShare) / (1 - kLeftShare);
        coordinates = {Coordinate(x * 0x1p32), random.next_uint()};
        PrimaryPath path(random, {}, 1, coordinates);
        const PrimaryPoint start = path.start();
        point = {float(start[0]), float(start[1])};
        weight = left ? 0.25 / kLeftShare : 0.75 / (1 - kLeftShare);
    }
};

/// One pass: `paths` independent ones, then `steps` steps of a chain.
struct Pass {
    StartPool pool{64};
    double share = 0;  // Z
    double sum = 0;    // of f over the steps
    ChainCounts counts;

    Pass(SpreadChain<Point>& chain, std::uint64_t pass, int paths, std::uint32_t steps,
         std::uint64_t segment_steps, bool weighted = true) {
        for (int i = 0; i < paths; ++i) {
            const Independent drawn(pass, std::uint64_t(i));
            if (!visible(drawn.point)) continue;
            const WeightedPath path{std::uint64_t(i), weighted ? drawn.weight : 1};
            pool.add({&path, 1}, 0.5);
            share += drawn.weight / paths;
        }
        if (pool.empty()) return;
        const float turn = RandomStream(9, pass, 0, RandomDomain::ChainStart).next();
        chain.begin_pass();
        chain.run(
            {9, pass, 0, 1}, steps, 6, segment_steps,
            [&](std::vector<Coordinate>& coordinates, Point& point, std::uint64_t segment) {
                const double at =
                    double(turn) + double(segment) * double(segment_steps) / double(steps);
                Independent start(pass, pool.at(at - std::floor(at)));
                coordinates = std::move(start.coordinates);
                point = start.point;
            },
            [&](PrimaryPath& path, Point& point, std::uint64_t) {
                const PrimaryPoint start = path.start();
                point = {float(start[0]), float(start[1])};
                return visible(point);
            },
            [&](std::span<const Coordinate>, const Point& point, std::uint32_t repeats) {
                sum += f(point) * repeats;
            },
            counts);
    }
};

struct Estimate {
    double mean = 0, error = 0;
};

/// About one visible path in a pass: many passes have none.
Estimate estimate_in_short_passes(std::uint64_t segment_steps, bool weighted) {
    constexpr std::uint64_t kPasses = 100000;
    double sum = 0, squares = 0;
    SpreadChain<Point> chain;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        const Pass p(chain, pass, 40, 12, segment_steps, weighted);
        if (p.pool.empty()) continue;
        EXPECT_EQ(p.counts.recorded, 12u);
        const double estimate = p.share * p.sum / double(p.counts.recorded);
        sum += estimate;
        squares += estimate * estimate;
    }
    const double mean = sum / kPasses;
    return {mean, std::sqrt((squares / kPasses - mean * mean) / kPasses)};
}

TEST(SpreadChain, NormalisedMeanIsUnbiasedInShortPasses) {
    for (const std::uint64_t segment_steps : {1u, 4u, 12u}) {
        const Estimate estimate = estimate_in_short_passes(segment_steps, true);
        EXPECT_LT(estimate.error, 0.01 * kIntegral);
        EXPECT_NEAR(estimate.mean, kIntegral, 3.9 * estimate.error) << segment_steps;
    }
}

/// The test above would find starts that were drawn without their weights.
TEST(SpreadChain, StartsWithoutTheirWeightsWouldBeFound) {
    const Estimate estimate = estimate_in_short_passes(4, false);
    EXPECT_GT(std::abs(estimate.mean - kIntegral), 4 * estimate.error);
}

TEST(SpreadChain, RecordsEachStepOnceOverRounds) {
    SpreadChain<int> chain;
    ChainCounts counts;
    std::uint64_t recorded = 0, starts = 0;
    chain.begin_pass();
    for (int round = 0; round < 50; ++round) {
        chain.run(
            {2, 0, 0, 1}, 37, 2, 16,
            [&](std::vector<Coordinate>& coordinates, int&, std::uint64_t segment) {
                EXPECT_EQ(segment, starts++);
                coordinates.assign(4, 0);
            },
            [&](PrimaryPath& path, int&, std::uint64_t) { return path.start()[0] < 0.3; },
            [&](std::span<const Coordinate> coordinates, int, std::uint32_t repeats) {
                EXPECT_EQ(coordinates.size(), 4u);
                recorded += repeats;
            },
            counts);
    }
    EXPECT_EQ(recorded, 50u * 37u);
    EXPECT_EQ(counts.recorded, 50u * 37u);
    EXPECT_EQ(starts, (50u * 37u + 15) / 16);
    EXPECT_EQ(counts.mutated, counts.recorded - starts);
}

TEST(StartPool, DrawsInProportionToWeights) {
    StartPool pool(8);
    const std::vector<WeightedPath> paths{{7, 1}, {8, 0.5}, {9, 2.5}};
    pool.add(paths, 0);
    EXPECT_EQ(pool.weight(), 4);
    EXPECT_EQ(pool.at(0), 7u);
    EXPECT_EQ(pool.at(0.2499), 7u);
    EXPECT_EQ(pool.at(0.25), 8u);
    EXPECT_EQ(pool.at(0.3749), 8u);
    EXPECT_EQ(pool.at(0.375), 9u);
    EXPECT_EQ(pool.at(std::nextafter(1.0, 0.0)), 9u);
    pool.clear();
    EXPECT_TRUE(pool.empty());
    EXPECT_EQ(pool.weight(), 0);
}

/// Thinned again and again; all of its weight stays, and each path keeps its part of it on average.
TEST(StartPool, ThinningKeepsTheExpectation) {
    constexpr std::uint64_t kPaths = 50;
    constexpr int kTrials = 40000;
    std::vector<double> observed(kPaths), expected(kPaths);
    double all = 0;
    for (std::uint64_t i = 0; i < kPaths; ++i)
        all += double(1 + i % 7);
    for (std::uint64_t i = 0; i < kPaths; ++i)
        expected[i] = kTrials * double(1 + i % 7) / all;
    for (int trial = 0; trial < kTrials; ++trial) {
        RandomStream random(3, 0, std::uint64_t(trial), RandomDomain::ChainStart);
        StartPool pool(8);
        for (std::uint64_t i = 0; i < kPaths; i += 2) {
            const std::vector<WeightedPath> paths{{i, double(1 + i % 7)},
                                                  {i + 1, double(1 + (i + 1) % 7)}};
            pool.add(paths, double(random.next()));
            ASSERT_LE(pool.size(), 8u);
        }
        ASSERT_NEAR(pool.weight(), all, 1e-9 * all);
        ++observed[pool.at(double(random.next()))];
    }
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, kSignificance) << result.describe;
}

TEST(WeightSums, TellHowManyEqualPathsTheyAreWorth) {
    WeightSums sums;
    EXPECT_EQ(sums.effective(), 0);
    for (int i = 0; i < 5; ++i)
        sums.add(0.25);
    EXPECT_DOUBLE_EQ(sums.effective(), 5);
    sums.add(1e6);
    EXPECT_NEAR(sums.effective(), 1, 1e-5);
}

}  // namespace
}  // namespace aips::spread_chain_test
