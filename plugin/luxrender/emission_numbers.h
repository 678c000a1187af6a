// LuxRender's lights take six numbers for a photon and three for a direction, the engine gives four
// and two: what is missing comes from digits that would not count.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "aips/core/base/vector.h"
#include "aips/core/sampling/low_discrepancy.h"
#include "aips/core/sampling/primary_point.h"

namespace aips::luxrender {

/// Numbers that a light is asked for a photon with.
struct EmissionNumbers {
    std::array<float, 3> place;      ///< the third chooses among parts of the light
    std::array<float, 3> direction;  ///< the third chooses among kinds of emission
};

/// `value`, a multiple of 2^-48 in [0, 1), as a float below 1.
inline float below_one(double value) {
    return std::fmin(float(value), 0x1.fffffep-1f);
}

/// Where a light has parts to choose among, the first `choice_bits` (at most 8) digits of the first
/// coordinate choose, so that a guide can tell the parts from each other; the digits that follow
/// are the place within. The coordinates' last 16 digits, which single precision would drop, are
/// the finer part of the choices.
inline EmissionNumbers emission_numbers(const PrimaryPoint& u, unsigned choice_bits) {
    const auto bits = [&](unsigned axis) { return static_cast<std::uint64_t>(u[axis] * 0x1p48); };
    constexpr std::uint64_t kAll = (std::uint64_t{1} << 48) - 1;
    const auto last = [&](unsigned axis) { return double(bits(axis) & 0xFFFFu) * 0x1p-16; };
    const std::uint64_t first = bits(0);
    const double part = double(first >> (48 - choice_bits));
    const double within = double(first << choice_bits & kAll) * 0x1p-48;
    const double choice = std::ldexp(part + last(0), -int(choice_bits));
    return {{below_one(within), below_one(u[1]), below_one(choice)},
            {below_one(u[2]), below_one(u[3]), below_one(last(2))}};
}

/// A third number for two: a hash of their digits, as good as independent of both.
inline float third_number(Vec2 u) {
    return to_unit_float(hash_bits(std::bit_cast<std::uint32_t>(u.x) +
                                   hash_bits(std::bit_cast<std::uint32_t>(u.y) ^ 0x9E3779B9u)));
}

}  // namespace aips::luxrender
