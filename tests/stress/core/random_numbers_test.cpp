// Protects: random numbers past 2^32 photons and 2^32 passes: no stream or stretch of the sequence
// comes again, and the sequence stays as even as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "aips/core/sampling/low_discrepancy.h"
#include "aips/core/sampling/random.h"
#include "stress_case.h"

namespace random_numbers_test {
namespace {

using namespace aips;
using namespace stress;

using Block = std::array<std::uint32_t, 4>;

std::size_t repetitions(std::vector<Block>& blocks) {
    std::sort(blocks.begin(), blocks.end());
    return std::size_t(blocks.end() - std::unique(blocks.begin(), blocks.end()));
}

/// About the ends of 32 bits, and multiples of 2^32 beyond.
std::vector<std::uint64_t> addresses(int neighbours) {
    std::vector<std::uint64_t> all;
    for (const std::uint64_t turn :
         {0ull, 1ull, 2ull, 3ull, 255ull, 0x80000000ull, 0xFFFFFFFFull}) {
        for (int i = 0; i < neighbours; ++i) {
            all.push_back((turn << 32) + std::uint64_t(i));
            all.push_back((turn << 32) + 0xFFFFFFFFull - std::uint64_t(i));
        }
    }
    return all;
}

TEST(StressRandom, NoStreamComesTwice) {
    const auto indices = addresses(sized(40, 200)), passes = addresses(sized(20, 50));
    std::vector<Block> blocks;
    for (const std::uint64_t pass : passes) {
        for (const std::uint64_t index : indices) {
            RandomStream stream(7, pass, index, RandomDomain::Photon);
            Block block{};
            for (std::uint32_t& bits : block)
                bits = stream.next_uint();
            blocks.push_back(block);
        }
    }
    const std::size_t count = blocks.size();
    EXPECT_EQ(repetitions(blocks), 0u);
    record(std::to_string(count) + " streams, indices and passes about multiples of 2^32",
           "no block of 128 bits twice");
}

Block point(std::uint64_t index) {
    Block bits{};
    for (unsigned d = 0; d < 4; ++d)
        bits[d] = std::uint32_t(sobol_owen(index, d, 5) * 0x1p24f);
    return bits;
}

TEST(StressRandom, NoPointOfTheSequenceComesTwice) {
    std::vector<Block> points;
    for (const std::uint64_t index : addresses(sized(10000, 200000)))
        points.push_back(point(index));
    const std::size_t count = points.size();
    EXPECT_EQ(repetitions(points), 0u);
    record(std::to_string(count) + " points of the sequence about multiples of 2^32",
           "no point of 96 bits twice");
}

/// What photons draw from: the run and the point by point definition are one across 2^32.
TEST(StressRandom, RunsGoOnAcrossTheTurn) {
    SobolRun run(5);
    for (std::uint64_t index = (1ull << 32) - 5000; index < (1ull << 32) + 5000; ++index) {
        run.move_to(index);
        for (unsigned d = 0; d < kSobolDimensions; ++d)
            ASSERT_EQ(run(d), sobol_owen(index, d, 5));
    }
    record("10,000 points from 2^32 - 5000 on", "the same by runs as one by one");
}

TEST(StressRandom, TheSequenceStaysStratified) {
    constexpr unsigned kBits = 10;
    for (const std::uint64_t turn : {1ull, 2ull, 1ull << 21, 0xFFFFFFFFull}) {
        const std::uint64_t first = (turn << 32) + (7u << kBits);
        for (unsigned d = 0; d < kSobolDimensions; ++d) {
            std::vector<int> met(1u << kBits, 0);
            for (std::uint64_t i = 0; i < (1u << kBits); ++i)
                ++met[std::size_t(sobol_owen(first + i, d, 5) * float(1u << kBits))];
            ASSERT_EQ(*std::max_element(met.begin(), met.end()), 1) << turn << ' ' << d;
        }
    }
    record("blocks of 1024 points beyond 2^32, 2^33, 2^53 and 2^63", "one in each 1024th");
}

}  // namespace
}  // namespace random_numbers_test
