// Protects the numbers of eye paths: uniform, stratified over the paths of a pixel, and independent
// from vertex to vertex, pixel to pixel and sequence to sequence.
#include "aips/core/sampling/eye_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "chi_square.h"

namespace aips::eye_numbers_test {
namespace {

constexpr std::size_t kNumbers = 7;

std::array<float, kNumbers> numbers_at(std::uint64_t pixel, std::uint64_t index,
                                       std::uint32_t depth, std::uint64_t sequence = 0) {
    const VertexNumbers v = EyeNumbers(7, sequence, pixel, index).vertex(depth);
    return {v.light().x,     v.light().y,     v.light_choice(), v.lobe(),
            v.direction().x, v.direction().y, v.end()};
}

TEST(EyeNumbers, AreStratifiedOverThePathsOfAPixel) {
    for (const unsigned count : {16u, 256u, 4096u}) {
        for (const std::uint32_t depth : {1u, 2u, 9u}) {
            std::array<std::set<unsigned>, kNumbers> strata;
            for (unsigned i = 0; i < count; ++i) {
                const auto numbers = numbers_at(1234, 3 * count + i, depth);
                for (std::size_t n = 0; n < kNumbers; ++n)
                    strata[n].insert(unsigned(numbers[n] * float(count)));
            }
            for (std::size_t n = 0; n < kNumbers; ++n)
                EXPECT_EQ(strata[n].size(), count) << n << " at vertex " << depth;
        }
    }
}

/// Where a pair of numbers has its second from.
struct Neighbour {
    std::string name;
    std::uint64_t pixel, index;
    std::uint32_t depth;
    std::uint64_t sequence;
};

// Each number with the same one, and with the next, elsewhere: as independent numbers fall.
TEST(EyeNumbers, AreUniformAndIndependentOfOthers) {
    constexpr std::size_t kCells = 16, kPairs = 40000;
    const std::vector<Neighbour> neighbours{{"the next vertex", 0, 0, 1, 0},
                                            {"two vertices on", 0, 0, 2, 0},
                                            {"the next pixel", 1, 0, 0, 0},
                                            {"another sequence", 0, 0, 0, 1},
                                            {"that and the next path", 0, 1, 0, 1}};
    // Over the pixels' first paths, and over a hundred paths of each of fewer pixels.
    for (const std::size_t paths : {1u, 100u}) {
        for (const Neighbour& other : neighbours) {
            for (std::size_t n = 0; n < kNumbers; ++n) {
                std::vector<double> same(kCells * kCells), next(kCells * kCells);
                for (std::size_t i = 0; i < kPairs; ++i) {
                    const std::uint64_t pixel = 2 * (i / paths), index = i % paths;
                    const auto a = numbers_at(pixel, index, 1);
                    const auto b = numbers_at(pixel + other.pixel, index + other.index,
                                              1 + other.depth, other.sequence);
                    const auto row = std::size_t(a[n] * kCells) * kCells;
                    ++same[row + std::size_t(b[n] * kCells)];
                    ++next[row + std::size_t(b[(n + 1) % kNumbers] * kCells)];
                }
                const std::vector<double> flat(same.size(), double(kPairs) / double(same.size()));
                for (const auto& hits : {same, next}) {
                    const auto result = test::chi_square(hits, flat);
                    EXPECT_GT(result.p_value, test::sidak(0.01, 140))
                        << other.name << ", number " << n << ", " << paths
                        << " paths a pixel: " << result.describe;
                }
            }
        }
    }
}

}  // namespace
}  // namespace aips::eye_numbers_test
