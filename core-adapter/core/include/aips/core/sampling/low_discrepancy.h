// Owen-scrambled Sobol' points.
// Sources: Joe & Kuo 2008 (direction numbers, new-joe-kuo-6.21201), Burley 2020 "Practical
// hash-based Owen scrambling", Laine & Karras 2011; constants of the permutation by Vegdahl 2021.
#pragma once

#include <array>
#include <cstdint>

#include "aips/core/sampling/random.h"

namespace aips {

/// Dimensions of the sequence.
inline constexpr unsigned kSobolDimensions = 8;

/// The generator matrix of one dimension: [byte of the index][its value] -> XOR of columns, with
/// the bits of the result reversed (least significant first), as scrambling wants them.
using SobolByteTables = std::array<std::array<std::uint32_t, 256>, 4>;
extern const std::array<SobolByteTables, kSobolDimensions> kSobolTables;

/// Mirrors the 32 bits.
constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
    x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// A bijective hash of 32 bits ("lowbias32", Wellons 2018).
constexpr std::uint32_t hash_bits(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7FEB352Du;
    x ^= x >> 15;
    x *= 0x846CA68Bu;
    return x ^ (x >> 16);
}

/// A permutation in which bit k of the result depends on bits 0..k only: on reversed bits, a nested
/// uniform (Owen) scramble.
constexpr std::uint32_t laine_karras_permutation(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526C56u;
    return x ^ (x * 0x53A22864u);
}

/// Point `index` of the Sobol' sequence in `dimension` (unchecked), before scrambling: a fraction
/// of 32 bits, the least significant bit first.
inline std::uint32_t sobol_reversed_bits(std::uint32_t index, unsigned dimension) {
    const SobolByteTables& t = kSobolTables[dimension];
    return t[0][index & 255u] ^ t[1][(index >> 8) & 255u] ^ t[2][(index >> 16) & 255u] ^
           t[3][index >> 24];
}

/// What the scrambles of all dimensions of point `index` have in common, see sobol_owen().
inline std::uint32_t sobol_epoch_seed(std::uint64_t index, std::uint32_t seed) {
    return hash_bits(seed ^ hash_bits(std::uint32_t(index >> 32)));
}

/// The seed of laine_karras_permutation() for a dimension.
inline std::uint32_t sobol_scramble(std::uint32_t epoch_seed, unsigned dimension) {
    return hash_bits(epoch_seed + dimension * 0x9E3779B9u);
}

/// sobol_owen() of a point whose epoch seed is known.
inline float sobol_owen_in_epoch(std::uint32_t index, unsigned dimension,
                                 std::uint32_t epoch_seed) {
    const std::uint32_t bits = sobol_reversed_bits(index, dimension);
    const std::uint32_t scramble = sobol_scramble(epoch_seed, dimension);
    return to_unit_float(reverse_bits(laine_karras_permutation(bits, scramble)));
}

/// Point `index` in `dimension` (< kSobolDimensions, unchecked), in [0, 1): a multiple of 2^-24.
/// `seed` selects the scramble; dimensions are scrambled independently. The sequence has 2^32
/// points; each further 2^32 is the same net under a scramble of its own. Every aligned block of
/// 2^k points is stratified as an Owen-scrambled net is, and each point is uniform over seeds.
inline float sobol_owen(std::uint64_t index, unsigned dimension, std::uint32_t seed) {
    return sobol_owen_in_epoch(std::uint32_t(index), dimension, sobol_epoch_seed(index, seed));
}

/// sobol_owen() for indices that mostly follow one another: what 256 neighbours have in common is
/// worked out once. Same numbers, to the bit.
class SobolRun {
  public:
    explicit SobolRun(std::uint32_t seed) : seed_(seed) {}

    /// Chooses the point.
    void move_to(std::uint64_t index) {
        if (index >> 8 != window_) enter(index >> 8);
        byte_ = index & 255u;
    }
    /// Its coordinate in `dimension` (< kSobolDimensions, unchecked) as a fraction of 32 bits;
    /// after move_to().
    std::uint32_t bits(unsigned dimension) const {
        const Dimension& d = dimensions_[dimension];
        const std::uint32_t unscrambled = d.upper_bits ^ kSobolTables[dimension][0][byte_];
        return reverse_bits(laine_karras_permutation(unscrambled, d.scramble));
    }
    /// The same in [0, 1): its first 24 bits.
    float operator()(unsigned dimension) const { return to_unit_float(bits(dimension)); }

  private:
    struct Dimension {
        std::uint32_t upper_bits, scramble;
    };

    void enter(std::uint64_t window);

    std::uint32_t seed_;
    std::uint32_t byte_ = 0;
    std::uint64_t window_ = ~std::uint64_t{0};  // index / 256; the initial value is none
    std::array<Dimension, kSobolDimensions> dimensions_{};
};

}  // namespace aips
