// Protects the small steps of Markov chains: symmetric on the circle, distributed as the paper
// says, and of a size that settles where the wanted share is accepted, never below its floor.
#include "aips/core/chains/mutation.h"

#include <gtest/gtest.h>

#include <vector>

#include "aips/core/sampling/random.h"
#include "chi_square.h"

namespace aips::mutation_test {
namespace {

constexpr double kSignificance = 1e-4;
constexpr int kDraws = 200000;

RandomStream stream(std::uint64_t index) {
    return {3, 0, index, RandomDomain::MutatedPath};
}

/// Signed distance on the circle in [-0.5, 0.5).
double distance(Coordinate from, Coordinate to) {
    return double(std::int32_t(to - from)) * 0x1p-32;
}

/// P(|step| <= s) = s^(1 / exponent), in both directions alike. Steps beyond half the circle are
/// left out of sight by starting from one place and counting the length before it wraps.
TEST(Mutation, StepsFollowThePowerLawAndAreSymmetric) {
    constexpr float kExponent = 5;
    constexpr std::size_t kCells = 20;
    std::vector<double> observed(2 * kCells), expected(2 * kCells);
    RandomStream random = stream(0);
    double inside = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double d = distance(0x12345678u, mutate(0x12345678u, random.next_uint(), kExponent));
        // Lengths in equal cells of their own distribution, up to a quarter of the circle: a step
        // that wrapped past a half cannot look shorter than a quarter unless longer than 3/4.
        const double u = std::pow(std::abs(d), 1.0 / double(kExponent));
        const auto cell = std::size_t(u * kCells);
        if (std::abs(d) >= 0.25) continue;
        // Steps below 2^-32 have lost their sign.
        const bool backward = d < 0 || (d == 0 && i % 2 == 1);
        ++observed[(backward ? kCells : 0) + cell];
        ++inside;
    }
    // Steps of length l in (3/4, 1) look like 1 - l the other way.
    const auto below = [&](double s) {
        return std::pow(s, 1.0 / double(kExponent)) +
               (1 - std::pow(1 - s, 1.0 / double(kExponent)));
    };
    for (std::size_t c = 0; c < kCells; ++c) {
        const double low = std::min(0.25, std::pow(double(c) / kCells, double(kExponent)));
        const double high = std::min(0.25, std::pow(double(c + 1) / kCells, double(kExponent)));
        const double share = (below(high) - below(low)) / below(0.25) / 2;
        expected[c] = expected[kCells + c] = share * inside;
    }
    const auto result = test::chi_square(observed, expected);
    EXPECT_GT(result.p_value, kSignificance) << result.describe;
}

/// The kernel leaves the uniform distribution as it is and is reversible: the counts of moves from
/// cell a to cell b and from b to a are equal in expectation (each difference over the square root
/// of the sum is standard normal), also across the wrap-around.
TEST(Mutation, IsReversible) {
    constexpr std::size_t kCells = 8;
    std::vector<double> moves(kCells * kCells);
    RandomStream random = stream(1);
    const auto cell = [](Coordinate x) { return std::size_t(x >> 29); };
    for (int i = 0; i < kDraws; ++i) {
        const Coordinate x = random.next_uint();
        ++moves[cell(x) * kCells + cell(mutate(x, random.next_uint(), 3))];
    }
    double chi = 0;
    int degrees = 0;
    for (std::size_t a = 0; a < kCells; ++a) {
        for (std::size_t b = a + 1; b < kCells; ++b) {
            const double there = moves[a * kCells + b], back = moves[b * kCells + a];
            ASSERT_GT(there + back, 100);
            chi += (there - back) * (there - back) / (there + back);
            ++degrees;
        }
    }
    EXPECT_GT(test::chi_square_tail(chi, degrees), kSignificance);
}

TEST(Mutation, ExtremeBitsStayOnTheCircle) {
    for (const float exponent : {1.125f, 2.0f, 33.0f}) {
        EXPECT_EQ(mutate(7, 0, 33), 7u);  // the smallest step is none
        for (const std::uint32_t bits : {0xFFFFFFFFu, 0xFFFFFFFEu}) {
            const Coordinate moved = mutate(0, bits, exponent);
            EXPECT_LT(std::abs(distance(0, moved)), 1e-5) << "almost a full turn";
        }
    }
}

TEST(MutationSize, FollowsTheEquation) {
    MutationSize size;
    EXPECT_EQ(size.size(), 1);
    EXPECT_EQ(size.exponent(), 2);
    size.learn(0.5, 1);
    EXPECT_NEAR(size.size(), 1 + std::log(3.0) * (0.5 - 0.234), 1e-12);
    EXPECT_EQ(size.steps(), 1u);
}

TEST(MutationSize, KeepsToFloorAndCapAndComesBack) {
    MutationSize size;
    for (int i = 0; i < 1000; ++i)
        size.learn(0, 100);
    EXPECT_EQ(size.size(), MutationSize::kFloor);
    size.learn(1, 100000);
    EXPECT_GT(size.size(), 2 * MutationSize::kFloor);
    size.learn(1, 1'000'000'000'000);
    EXPECT_EQ(size.size(), MutationSize::kCap);
}

/// Where the acceptance falls with the size as 1 / (1 + 10 s), 23.4 % lies at s = 0.327.
TEST(MutationSize, SettlesAtTheGoal) {
    MutationSize size;
    for (int i = 0; i < 20000; ++i)
        size.learn(1 / (1 + 10 * size.size()), 1);
    EXPECT_NEAR(size.size(), (1 / MutationSize::kGoal - 1) / 10, 0.02);
}

}  // namespace
}  // namespace aips::mutation_test
