// Protects the random numbers of a path: a pure function of their address, in [0,1), uniform.
#include "path/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lxs::test::random_stream_test {
namespace {

TEST(RandomStream, DependsOnSeedPassPixelAndDimension) {
    const float first = RandomStream(1, 2, 3).next();
    EXPECT_EQ(first, RandomStream(1, 2, 3).next());
    EXPECT_NE(first, RandomStream(2, 2, 3).next());
    EXPECT_NE(first, RandomStream(1, 3, 3).next());
    EXPECT_NE(first, RandomStream(1, 2, 4).next());
    EXPECT_NE(first, RandomStream(1 + (std::uint64_t{1} << 32), 2, 3).next());
    EXPECT_NE(first, RandomStream(1, 2 + (std::uint64_t{1} << 32), 3).next());
    RandomStream stream(1, 2, 3);
    stream.next();
    EXPECT_NE(first, stream.next());
}

// Chi-square over 64 cells: the 99.99 % quantile at 63 degrees of freedom is 115.6.
TEST(RandomStream, IsUniform) {
    constexpr int kCells = 64;
    constexpr int kDraws = 64'000;
    std::array<int, kCells> counts{};
    for (std::uint32_t pixel = 0; pixel < kDraws / 16; ++pixel) {
        RandomStream stream(7, 0, pixel);
        for (int i = 0; i < 16; ++i) {
            const float u = stream.next();
            ASSERT_GE(u, 0.0f);
            ASSERT_LT(u, 1.0f);
            ++counts[static_cast<std::size_t>(u * kCells)];
        }
    }
    double chi_square = 0;
    for (const int count : counts) {
        constexpr double kExpected = double{kDraws} / kCells;
        chi_square += std::pow(count - kExpected, 2) / kExpected;
    }
    EXPECT_LT(chi_square, 115.6);
}

}  // namespace
}  // namespace lxs::test::random_stream_test
