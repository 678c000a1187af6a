// Protects the low-discrepancy emission: nets stay nets under scrambling, points stay unbiased,
// dimensions and epochs stay independent.
#include "aips/core/sampling/low_discrepancy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "aips/core/sampling/primary_point.h"
#include "chi_square.h"

namespace aips::low_discrepancy_test {
namespace {

constexpr double kSignificance = 1e-4;

float plain_sobol(std::uint32_t index, unsigned dimension) {
    return float(reverse_bits(sobol_reversed_bits(index, dimension))) * 0x1p-32f;
}

// First points of Joe & Kuo's sequence in three dimensions, in the order of the index's bits.
TEST(LowDiscrepancy, MatchesThePublishedSequence) {
    constexpr float kPoints[4][3] = {
        {0, 0, 0}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.75f, 0.75f}, {0.75f, 0.25f, 0.25f}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (unsigned d = 0; d < 3; ++d)
            EXPECT_EQ(plain_sobol(i, d), kPoints[i][d]);
    }
}

TEST(LowDiscrepancy, EveryDimensionIsAPermutationOfEachPrefix) {
    for (unsigned d = 0; d < kSobolDimensions; ++d) {
        std::vector<int> hits(1024);
        for (std::uint32_t i = 0; i < 1024; ++i)
            ++hits[std::size_t(plain_sobol(i, d) * 1024)];
        for (const int h : hits)
            ASSERT_EQ(h, 1) << "dimension " << d;
    }
}

// The (0, m, 2)-net: each elementary interval of area 2^-m holds one of 2^m consecutive points, in
// any aligned block, whatever the scramble.
TEST(LowDiscrepancy, FirstTwoDimensionsAreNetsUnderAnyScramble) {
    constexpr unsigned kLog = 8;
    constexpr std::uint64_t kCount = 1u << kLog;
    for (const std::uint64_t start : {std::uint64_t{0}, 5 * kCount, std::uint64_t{1} << 33}) {
        for (std::uint32_t seed = 0; seed < 10; ++seed) {
            for (unsigned log_x = 0; log_x <= kLog; ++log_x) {
                const auto nx = std::size_t{1} << log_x, ny = std::size_t{1} << (kLog - log_x);
                std::vector<int> hits(kCount);
                for (std::uint64_t i = start; i < start + kCount; ++i) {
                    const auto x = std::size_t(sobol_owen(i, 0, seed) * float(nx));
                    const auto y = std::size_t(sobol_owen(i, 1, seed) * float(ny));
                    ++hits[y * nx + x];
                }
                for (const int h : hits)
                    ASSERT_EQ(h, 1);
            }
        }
    }
}

// A fixed point, over seeds, is uniform in each dimension and independent between dimensions.
TEST(LowDiscrepancy, EachPointIsUniformOverScrambles) {
    constexpr std::size_t kCells = 16;
    constexpr std::uint32_t kSeeds = 40000;
    const std::uint64_t indices[] = {0, 1, 12345, (std::uint64_t{3} << 32) + 7};
    for (const std::uint64_t index : indices) {
        for (unsigned d = 0; d + 1 < kSobolDimensions; ++d) {
            std::vector<double> hits(kCells * kCells);
            for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
                const auto x = std::size_t(sobol_owen(index, d, seed) * kCells);
                const auto y = std::size_t(sobol_owen(index, d + 1, seed) * kCells);
                ++hits[y * kCells + x];
            }
            const std::vector<double> flat(kCells * kCells, double(kSeeds) / (kCells * kCells));
            const auto result = test::chi_square(hits, flat);
            EXPECT_GT(result.p_value, test::sidak(kSignificance, 28)) << result.describe;
        }
    }
}

// The mean of a smooth integrand over scrambles is exact within its standard error, and the spread
// is far below that of independent numbers.
TEST(LowDiscrepancy, IntegratesWithoutBiasAndWithLessVariance) {
    constexpr int kSeeds = 2000;
    constexpr int kPoints = 64;
    double sum = 0, squares = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        double estimate = 0;
        for (std::uint64_t i = 0; i < kPoints; ++i) {
            double product = 1;
            for (unsigned d = 0; d < 5; ++d)
                product *= 0.5 + double(sobol_owen(i, d, seed));
            estimate += product / kPoints;
        }
        sum += estimate;
        squares += estimate * estimate;
    }
    const double mean = sum / kSeeds;
    const double variance = squares / kSeeds - mean * mean;
    const double independent = (std::pow(13.0 / 12.0, 5) - 1) / kPoints;
    EXPECT_NEAR(mean, 1.0, 4 * std::sqrt(variance / kSeeds) + 1e-6);
    EXPECT_LT(variance, independent / 10);
}

TEST(LowDiscrepancy, EpochsAreScrambledAnew) {
    int equal = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        equal += sobol_owen(i, 0, 1) == sobol_owen(i + (std::uint64_t{1} << 32), 0, 1) ? 1 : 0;
    }
    EXPECT_LT(equal, 5);
}

/// A guide may go to a cell of 2^-24 alone, or to one yet smaller: along each axis points differ
/// there, and fill it evenly. Of neighbours in the sequence, which agree in what comes first.
TEST(SobolRun, PointsAreFinerThanSinglePrecision) {
    constexpr std::size_t kCells = 16;
    SobolRun run(7);
    for (unsigned axis = 0; axis < 4; ++axis) {
        std::vector<double> observed(kCells * kCells);
        constexpr std::uint64_t kPoints = 1 << 16;
        for (std::uint64_t i = 0; i < kPoints; ++i) {
            run.move_to(i);
            const double x =
                primary_point({run.bits(0), run.bits(1), run.bits(2), run.bits(3)})[axis];
            ASSERT_EQ(float(std::floor(x * 0x1p24) * 0x1p-24), run(axis));
            ++observed[std::size_t(std::fmod(x * 0x1p36, double(kCells))) * kCells +
                       std::size_t(std::fmod(x * 0x1p44, double(kCells)))];
        }
        const std::vector<double> expected(observed.size(),
                                           double(kPoints) / double(observed.size()));
        const auto result = test::chi_square(observed, expected);
        EXPECT_GT(result.p_value, 1e-4) << axis << ": " << result.describe;
    }
}

TEST(SobolRun, IsTheSequenceToTheBitInAnyOrder) {
    constexpr std::uint64_t kEpoch = std::uint64_t{1} << 32;
    for (const std::uint32_t seed : {0u, 7u, 0xFFFFFFFFu}) {
        SobolRun run(seed);
        for (const std::uint64_t start :
             {std::uint64_t{0}, std::uint64_t{200}, std::uint64_t{3} << 24, kEpoch - 100,
              std::uint64_t{90}, 5 * kEpoch + 1000}) {
            for (std::uint64_t i = start; i < start + 600; ++i) {
                run.move_to(i);
                for (unsigned d = 0; d < kSobolDimensions; ++d)
                    ASSERT_EQ(run(d), sobol_owen(i, d, seed)) << i;
            }
        }
    }
}

}  // namespace
}  // namespace aips::low_discrepancy_test
