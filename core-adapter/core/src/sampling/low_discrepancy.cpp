// Generator matrices of the Sobol' sequence, by bytes of the index.
#include "aips/core/sampling/low_discrepancy.h"

namespace aips {
namespace {

constexpr unsigned kBits = 32;

/// A primitive polynomial x^s + a_1 x^(s-1) + ... + 1 (the inner coefficients as bits of `a`) and
/// its initial direction numbers m_1 .. m_s.
struct Generator {
    unsigned s, a;
    std::array<std::uint32_t, 5> m;
};

/// Dimensions 2 to 8 of new-joe-kuo-6.21201 (Joe & Kuo 2008); the first is van der Corput's.
constexpr std::array<Generator, kSobolDimensions - 1> kGenerators{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
}};

/// Column i of the generator matrix: what bit i of the index adds, as 0.32 fixed point (Bratley &
/// Fox 1988, the recurrence of v_i).
constexpr std::array<std::uint32_t, kBits> columns(unsigned dimension) {
    std::array<std::uint32_t, kBits> v{};
    if (dimension == 0) {
        for (unsigned i = 0; i < kBits; ++i)
            v[i] = 1u << (kBits - 1 - i);
        return v;
    }
    const Generator& g = kGenerators[dimension - 1];
    for (unsigned i = 0; i < g.s; ++i)
        v[i] = g.m[i] << (kBits - 1 - i);
    for (unsigned i = g.s; i < kBits; ++i) {
        v[i] = v[i - g.s] ^ (v[i - g.s] >> g.s);
        for (unsigned k = 1; k < g.s; ++k) {
            if ((g.a >> (g.s - 1 - k)) & 1u) v[i] ^= v[i - k];
        }
    }
    return v;
}

constexpr SobolByteTables byte_tables(unsigned dimension) {
    const auto column = columns(dimension);
    SobolByteTables tables{};
    for (unsigned byte = 0; byte < 4; ++byte) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            const std::uint32_t reversed = reverse_bits(column[byte * 8 + bit]);
            // Entries with this bit as their highest: those below it, and the column.
            for (unsigned low = 0; low < (1u << bit); ++low) {
                tables[byte][(1u << bit) + low] = tables[byte][low] ^ reversed;
            }
        }
    }
    return tables;
}

constexpr std::array<SobolByteTables, kSobolDimensions> all_tables() {
    std::array<SobolByteTables, kSobolDimensions> tables{};
    for (unsigned d = 0; d < kSobolDimensions; ++d)
        tables[d] = byte_tables(d);
    return tables;
}

}  // namespace

constexpr std::array<SobolByteTables, kSobolDimensions> kSobolTables = all_tables();

void SobolRun::enter(std::uint64_t window) {
    window_ = window;
    const std::uint64_t first = window << 8;
    const std::uint32_t epoch_seed = sobol_epoch_seed(first, seed_);
    for (unsigned d = 0; d < kSobolDimensions; ++d) {
        dimensions_[d] = {sobol_reversed_bits(static_cast<std::uint32_t>(first), d),
                          sobol_scramble(epoch_seed, d)};
    }
}

}  // namespace aips
