// Winsorised sum of footprints, whose median is found by counting.
#include "eye/footprints.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/ordered_sum.h"
#include "eye/constants.h"

namespace aips {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
using Counts = std::vector<std::uint32_t>;  // [digit]

/// Bits that are ordered as floats are.
std::uint32_t ordered_bits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

float from_ordered_bits(std::uint32_t bits) {
    return std::bit_cast<float>(bits & 0x80000000u ? bits & 0x7FFFFFFFu : ~bits);
}

/// Of the finite footprints whose bits from `shift + kDigitBits` on are those of `known`: how many
/// have which digit above `shift`.
Counts count_digits(std::span<const float> footprints, std::uint32_t known, unsigned shift) {
    constexpr std::size_t kFootprintsPerJob = std::size_t{1} << 15;
    const std::uint64_t mask = ~((std::uint64_t{1} << (shift + kDigitBits)) - 1);
    std::vector<Counts> jobs(footprints.size() / kFootprintsPerJob + 1);
    in_chunks(footprints.size(), kFootprintsPerJob, tbb_for,
              [&](std::size_t first, std::size_t last) {
                  Counts& counts = jobs[first / kFootprintsPerJob];
                  counts.assign(kDigits, 0);
                  for (const float footprint : footprints.subspan(first, last - first)) {
                      const std::uint32_t bits = ordered_bits(footprint);
                      if (std::isfinite(footprint) && (bits & mask) == (known & mask))
                          ++counts[bits >> shift & (kDigits - 1)];
                  }
              });
    Counts sum(kDigits, 0);
    for (const Counts& counts : jobs) {
        for (std::size_t d = 0; d < counts.size(); ++d)
            sum[d] += counts[d];
    }
    return sum;
}

/// The finite footprint that `rank` others come before.
float footprint_of_rank(std::span<const float> footprints, std::size_t rank) {
    std::uint32_t bits = 0;
    for (const unsigned shift : {22u, 11u, 0u}) {
        const Counts counts = count_digits(footprints, bits, shift);
        std::uint32_t digit = 0;
        for (; rank >= counts[digit]; ++digit)
            rank -= counts[digit];
        bits |= digit << shift;
    }
    return from_ordered_bits(bits);
}

}  // namespace

double bounded_footprint_sum(std::span<const float> footprints) {
    const auto finite =
        ordered_sum<std::size_t>(footprints.size(), [&](std::size_t first, std::size_t last) {
            return std::size_t(
                std::ranges::count_if(footprints.subspan(first, last - first),
                                      [](float footprint) { return std::isfinite(footprint); }));
        });
    if (finite == 0) return 0;
    const float median = footprint_of_rank(footprints, finite / 2);
    // A median of zero bounds nothing: such a camera has no footprints for most of its pixels.
    const float most = median > 0 ? kMostMedians * median : std::numeric_limits<float>::infinity();
    return ordered_sum<double>(footprints.size(), [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (const float footprint : footprints.subspan(first, last - first)) {
            if (std::isfinite(footprint)) sum += double(std::min(footprint, most));
        }
        return sum;
    });
}

}  // namespace aips
