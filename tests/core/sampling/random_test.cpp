// Protects the addressed random streams: range, uniformity, independence, reproducibility.
#include "aips/core/sampling/random.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "chi_square.h"

namespace aips::random_test {
namespace {

constexpr double kSignificance = 1e-4;

TEST(Random, UnitFloatNeverReachesOne) {
    EXPECT_EQ(to_unit_float(0), 0.0f);
    EXPECT_LT(to_unit_float(0xFFFFFFFFu), 1.0f);
    EXPECT_EQ(to_unit_float(0x80000000u), 0.5f);
}

// The generator's published test vector (Random123, kat_vectors: philox4x32 10, all zero), so that
// the numbers are Philox's and stay so.
TEST(Random, IsPhilox) {
    RandomStream stream(0, 0, 0, RandomDomain::Photon);
    EXPECT_EQ(stream.next_uint(), 0x6627e8d5u);
    EXPECT_EQ(stream.next_uint(), 0xe169c58du);
    EXPECT_EQ(stream.next_uint(), 0xbc57ac4cu);
    EXPECT_EQ(stream.next_uint(), 0x9b00dbd8u);
}

TEST(Random, EveryPartOfTheAddressMatters) {
    const auto first = [](std::uint64_t seed, std::uint64_t pass, std::uint64_t index,
                          RandomDomain domain) {
        RandomStream stream(seed, pass, index, domain);
        return std::uint64_t{stream.next_uint()} << 32 | stream.next_uint();
    };
    constexpr std::uint64_t kHigh = std::uint64_t{1} << 40;
    const std::set<std::uint64_t> distinct{first(1, 2, 3, RandomDomain::Photon),
                                           first(2, 2, 3, RandomDomain::Photon),
                                           first(1, 3, 3, RandomDomain::Photon),
                                           first(1, 2, 4, RandomDomain::Photon),
                                           first(1, 2, 3, RandomDomain::Eye),
                                           first(1 + kHigh, 2, 3, RandomDomain::Photon),
                                           first(1, 2 + kHigh, 3, RandomDomain::Photon),
                                           first(1, 2, 3 + kHigh, RandomDomain::Photon)};
    EXPECT_EQ(distinct.size(), 8u);
    EXPECT_EQ(first(1, 2, 3, RandomDomain::Photon), first(1, 2, 3, RandomDomain::Photon));
}

// Pairs of consecutive numbers, and of equal positions in neighbouring streams, fill the square.
TEST(Random, PairsAreUniformWithinAndAcrossStreams) {
    constexpr std::size_t kCells = 16;
    constexpr int kStreams = 20000;
    std::vector<double> within(kCells * kCells), across(kCells * kCells);
    float previous = 0.5f;
    int draws = 0;
    for (int i = 0; i < kStreams; ++i) {
        RandomStream stream(7, 1, std::uint64_t(i), RandomDomain::Photon);
        const Vec2 u = stream.next2();
        const auto cell = [](float x) { return std::size_t(x * float(kCells)); };
        ++within[cell(u.y) * kCells + cell(u.x)];
        if (i > 0) {
            ++across[cell(previous) * kCells + cell(u.x)];
            ++draws;
        }
        previous = u.x;
    }
    const std::vector<double> flat(kCells * kCells, double(kStreams) / (kCells * kCells));
    const std::vector<double> flat_across(kCells * kCells, double(draws) / (kCells * kCells));
    const auto a = test::chi_square(within, flat);
    const auto b = test::chi_square(across, flat_across);
    EXPECT_GT(a.p_value, test::sidak(kSignificance, 2)) << a.describe;
    EXPECT_GT(b.p_value, test::sidak(kSignificance, 2)) << b.describe;
}

TEST(Random, LongStreamsDoNotRepeat) {
    RandomStream stream(3, 0, 0, RandomDomain::Eye);
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 5000; ++i) {
        const std::uint64_t high = stream.next_uint();
        seen.insert(high << 32 | stream.next_uint());
    }
    EXPECT_EQ(seen.size(), 5000u);
}

}  // namespace
}  // namespace aips::random_test
