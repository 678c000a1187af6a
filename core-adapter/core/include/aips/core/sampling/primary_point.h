// The coordinates from which a light emits a photon, finer than single precision tells apart.
#pragma once

#include <array>
#include <cstdint>

namespace aips {

/// Coordinates from which a light emits a photon, in [0, 1)^4. Multiples of 2^-24, as single
/// precision has them, lie 3 cm apart on the disc of an emitter at infinity around a scene of 500
/// km, and a view that is no wider sees dots that never converge.
using PrimaryPoint = std::array<double, 4>;

/// The point whose coordinates begin with 32 bits each; the 16 bits that follow are a hash of all
/// of these. Where the 128 bits are uniform and independent, each coordinate, and the low bits
/// given the high ones of fewer than four axes, are as good as uniform; but for one pair in 65536,
/// points that agree along one axis to 32 bits, as those of a lattice do, do not agree to 48.
inline PrimaryPoint primary_point(const std::array<std::uint32_t, 4>& bits) {
    // Two rounds of a multiplication and a shift for each half (after "degski64", 2018).
    constexpr std::uint64_t kFactor = 0xD6E8FEB86659FD93u;
    std::uint64_t hash = (std::uint64_t{bits[0]} << 32 | bits[1]) * kFactor;
    hash = (hash ^ hash >> 32) + (std::uint64_t{bits[2]} << 32 | bits[3]);
    hash = (hash ^ hash >> 32) * kFactor;
    hash = (hash ^ hash >> 32) * kFactor;
    hash ^= hash >> 32;
    PrimaryPoint point;
    for (unsigned axis = 0; axis < 4; ++axis) {
        const std::uint64_t all = std::uint64_t{bits[axis]} << 16 | (hash >> 16 * axis & 0xFFFFu);
        // Signed numbers of 64 bits become doubles in one instruction.
        point[axis] = double(static_cast<std::int64_t>(all)) * 0x1p-48;
    }
    return point;
}

}  // namespace aips
