// Protects the Markov chain over visible paths: its states are uniform on the visible set, its
// normalisation is unbiased from the first step, its coordinates keep their meaning.
#include "aips/core/chains/visibility_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chi_square.h"

namespace aips::visibility_chain_test {
namespace {

constexpr double kSignificance = 1e-4;

using Point = std::array<float, 2>;

/// Two islands in the square, together 0.02 of it: one in a corner, wrapped around both edges, and
/// a thin diagonal strip.
bool in_islands(const Point& p) {
    const float x = p[0] < 0.5f ? p[0] : p[0] - 1, y = p[1] < 0.5f ? p[1] : p[1] - 1;
    const bool corner = std::abs(x) < 0.05f && std::abs(y) < 0.05f;
    const bool strip = p[0] >= 0.25f && p[0] < 0.75f && std::abs(p[1] - p[0]) < 0.01f;
    return corner || strip;
}

/// Traces paths whose emission is a point of the square.
auto square_tracer(bool (*visible)(const Point&)) {
    return [visible](PrimaryPath& path, Point& point, std::uint64_t) {
        const PrimaryPoint start = path.start();
        point = {float(start[0]), float(start[1])};
        return visible(point);
    };
}

/// Cell of a point: the corner by quadrants of 4 x 4, the strip by 20 cells along it.
std::size_t cell(const Point& p) {
    if (p[0] >= 0.25f && p[0] < 0.75f) return 16 + std::size_t((p[0] - 0.25f) * 40);
    const auto quarter = [](float v) {
        return std::size_t((v < 0.5f ? v + 0.05f : v - 0.95f) * 40);
    };
    return std::min<std::size_t>(3, quarter(p[1])) * 4 + std::min<std::size_t>(3, quarter(p[0]));
}

/// The last state of many short chains: independent of each other, so chi-square applies. Chains
/// are long enough for most of their moves to be mutations.
TEST(VisibilityChain, StatesAreUniformOnTheVisibleSet) {
    constexpr std::uint64_t kPasses = 40000;
    std::vector<double> observed(36);
    VisibilityChain<Point> chain;
    ChainCounts counts;
    double total = 0;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        chain.begin_pass(500);
        chain.run(
            {9, pass, 0, 1}, 100, 9, square_tracer(in_islands), [](const Point&, std::uint32_t) {},
            counts);
        if (!chain.has_state()) continue;
        ++observed[cell(chain.current())];
        ++total;
    }
    std::vector<double> expected(36);
    for (std::size_t c = 0; c < 36; ++c)
        expected[c] = total * (c < 16 ? 0.01 / 16 : 0.01 / 20) / 0.02;
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, kSignificance) << result.describe;
    EXPECT_GT(total, kPasses / 2);
    EXPECT_GT(counts.accepted, 2 * counts.visible) << "the test must rest on mutations";
}

/// visible / measured * mean over recorded states is the integral over the square, z-tested over
/// passes too short for most chains to see more than one independent visible path. Chains that
/// found nothing count as zero. With all independent paths measured it would be 10 % too bright.
TEST(VisibilityChain, NormalisedMeanIsUnbiasedInShortPasses) {
    constexpr std::uint64_t kPasses = 60000;
    const auto f = [](const Point& p) { return 1 + double(p[0]) * 3; };
    // Integral over the islands: the strip's mean is f(1/2); the corner has x near 0 and near 1.
    const double exact = 0.01 * 2.5 + 0.005 * (1 + 0.025 * 3) + 0.005 * (1 + 0.975 * 3);
    double sum = 0, squares = 0;
    VisibilityChain<Point> chain;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        ChainCounts counts;
        double recorded = 0;
        chain.begin_pass(60);
        chain.run(
            {10, pass, 0, 1}, 120, 5, square_tracer(in_islands),
            [&](const Point& p, std::uint32_t repeats) { recorded += f(p) * repeats; }, counts);
        ASSERT_EQ(counts.uniform + counts.mutated, 120u);
        ASSERT_EQ(counts.measured, 60u);
        if (counts.recorded == 0) continue;
        const double estimate =
            double(counts.visible) / double(counts.measured) * recorded / double(counts.recorded);
        sum += estimate;
        squares += estimate * estimate;
    }
    const double mean = sum / kPasses;
    const double error = std::sqrt((squares / kPasses - mean * mean) / kPasses);
    EXPECT_LT(error, 0.01 * exact);
    EXPECT_NEAR(mean, exact, 3.9 * error);
}

/// Everything visible: no mutation at all, each path recorded once.
TEST(VisibilityChain, WhereAllIsVisiblePathsAreIndependent) {
    VisibilityChain<Point> chain;
    ChainCounts counts;
    std::uint64_t records = 0;
    chain.begin_pass(500);
    chain.run(
        {1, 0, 0, 1}, 1000, 2, square_tracer([](const Point&) { return true; }),
        [&](const Point&, std::uint32_t repeats) {
            EXPECT_EQ(repeats, 1u);
            ++records;
        },
        counts);
    EXPECT_EQ(counts.uniform, 1000u);
    EXPECT_EQ(counts.measured, 500u);
    EXPECT_EQ(counts.visible, 500u);
    EXPECT_EQ(counts.mutated, 0u);
    EXPECT_EQ(records, 1000u);
}

TEST(VisibilityChain, WhereNothingIsVisibleNothingIsRecorded) {
    VisibilityChain<Point> chain;
    ChainCounts counts;
    chain.begin_pass(500);
    chain.run(
        {1, 0, 0, 1}, 1000, 2, square_tracer([](const Point&) { return false; }),
        [](const Point&, std::uint32_t) { FAIL(); }, counts);
    EXPECT_EQ(counts.uniform, 1000u);
    EXPECT_EQ(counts.recorded, 0u);
    EXPECT_FALSE(chain.has_state());
}

/// A state that lasts is recorded with the steps that it lasted, over rounds too.
TEST(VisibilityChain, RepeatsAddUpToTheStepsRecorded) {
    VisibilityChain<Point> chain;
    ChainCounts counts;
    std::uint64_t repeats_sum = 0;
    chain.begin_pass(500);
    for (int round = 0; round < 50; ++round) {
        chain.run(
            {2, 0, 0, 1}, 37, 9, square_tracer(in_islands),
            [&](const Point&, std::uint32_t repeats) { repeats_sum += repeats; }, counts);
    }
    EXPECT_GT(counts.recorded, 100u);
    EXPECT_EQ(repeats_sum, counts.recorded);
    EXPECT_EQ(counts.uniform + counts.mutated, 50u * 37u);
}

/// The numbers of a bounce stay its own when an earlier bounce leaves some of its numbers unused.
TEST(PrimaryPath, CoordinatesKeepTheirPlace) {
    const RandomStream random(5, 6, 7, RandomDomain::UniformPath);
    std::vector<Coordinate> all, some;
    PrimaryPath first(random, {}, 1, all), second(random, {}, 1, some);
    first.start();
    PrimaryPath& bounce = first.bounce(1);
    for (unsigned i = 0; i < kBounceCoordinates; ++i)
        bounce.next();
    const float expected = first.bounce(2).next();
    second.bounce(1).next2();
    EXPECT_EQ(second.bounce(2).next(), expected);
    EXPECT_EQ(all, some);
    EXPECT_EQ(all.size(), max_coordinates(1) + 1);
}

/// Whatever a path asks for: more than a bounce's coordinates, a depth again, a lesser depth again.
TEST(PrimaryPath, HandsOutNoNumberTwice) {
    std::vector<Coordinate> used;
    PrimaryPath path(RandomStream(5, 6, 7, RandomDomain::UniformPath), {}, 1, used);
    path.start();
    std::vector<float> numbers{path.light_choice()};
    const auto ask = [&](std::uint32_t depth, unsigned count) {
        PrimaryPath& bounce = path.bounce(depth);
        for (unsigned i = 0; i < count; ++i)
            numbers.push_back(bounce.next());
    };
    ask(1, 2);
    ask(1, kBounceCoordinates);
    ask(2, kBounceCoordinates + 3);
    ask(1, 3);
    ask(2, 2);
    ask(3, kBounceCoordinates);
    ask(4, 1);
    std::sort(numbers.begin(), numbers.end());
    EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end());
    EXPECT_EQ(used.size(), max_coordinates(3) + 1) << "the rest is not kept";
}

/// What is beyond a bounce's coordinates is no part of the state, and so is never mutated: a tiny
/// mutation leaves all coordinates about where they were, and none of the rest.
TEST(PrimaryPath, DrawsAnewWhatIsBeyondABounce) {
    const auto numbers = [](const RandomStream& random, std::span<const Coordinate> from,
                            std::vector<Coordinate>& used) {
        PrimaryPath path(random, from, 1e6f, used);
        std::vector<float> drawn;
        for (const std::uint32_t depth : {1u, 2u}) {
            for (unsigned i = 0; i < kBounceCoordinates + 2; ++i)
                drawn.push_back(path.bounce(depth).next());
        }
        return drawn;
    };
    std::vector<Coordinate> state, moved;
    const auto before = numbers(RandomStream(5, 6, 8, RandomDomain::UniformPath), {}, state);
    const auto after = numbers(RandomStream(5, 6, 9, RandomDomain::MutatedPath), state, moved);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool kept = i % (kBounceCoordinates + 2) < kBounceCoordinates;
        EXPECT_EQ(std::abs(after[i] - before[i]) < 1e-6f, kept) << i;
    }
}

/// The bits of a coordinate that single precision does not see are uniform and independent of those
/// that it does.
TEST(PrimaryPath, StartsAreFinerThanSinglePrecision) {
    constexpr std::size_t kCells = 16;
    constexpr int kDraws = 40000;
    for (unsigned axis = 0; axis < 4; ++axis) {
        std::vector<double> observed(kCells * kCells);
        for (std::uint64_t i = 0; i < kDraws; ++i) {
            std::vector<Coordinate> used;
            PrimaryPath path(RandomStream(5, axis, i, RandomDomain::UniformPath), {}, 1, used);
            const double x = path.start()[axis];
            ASSERT_TRUE(x >= 0 && x < 1);
            // The last of 24 bits and three more, and four beyond 32.
            const auto fine = std::size_t(std::fmod(x * 0x1p27, double(kCells)));
            const auto finest = std::size_t(std::fmod(x * 0x1p36, double(kCells)));
            ++observed[fine * kCells + finest];
        }
        const std::vector<double> expected(observed.size(),
                                           double(kDraws) / double(observed.size()));
        const auto result = test::chi_square(observed, expected);
        EXPECT_GT(result.p_value, kSignificance) << axis << ": " << result.describe;
    }
}

/// A mutation moves the coordinates it has and draws the ones it lacks.
TEST(PrimaryPath, MutatesWhatIsThereAndDrawsTheRest) {
    const std::vector<Coordinate> state{0x80000000u, 0x80000000u};
    double moved = 0, squares = 0;
    constexpr int kDraws = 2000;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
        std::vector<Coordinate> used;
        PrimaryPath path(RandomStream(5, 6, i, RandomDomain::MutatedPath), state, 20, used);
        path.start();
        const double near = double(to_unit_float(used[0])) - 0.5;
        const double drawn = double(to_unit_float(used[2])) - 0.5;
        moved += near * near;
        squares += drawn * drawn;
    }
    // Of a step xi^20 the mean square is 1 / 41, less what wraps; of a uniform number 1 / 12.
    EXPECT_LT(moved / kDraws, 0.03);
    EXPECT_NEAR(squares / kDraws, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / kDraws));
}

}  // namespace
}  // namespace aips::visibility_chain_test
