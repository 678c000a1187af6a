// Robust ray origins.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lxs/sdk/types.h"

namespace lxs {

/// The float next to a finite `x`, away from zero if `outwards`, else towards it; from zero a step
/// towards zero leads to NaN.
inline float next_float(float x, bool outwards) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + (outwards ? 1u : ~0u));
}

/// Moves a ray's origin off a surface: `p` (finite) displaced along the geometric normal by the
/// bound of its rounding error, to the side that `direction` points to (Pharr et al. 2016, section
/// 3.9.5).
inline Vec3 offset_origin(const Vec3& p, const Vec3& p_error, const Vec3& ng,
                          const Vec3& direction) {
    // The error box's extent along the normal.
    const float extent =
        std::abs(ng.x) * p_error.x + std::abs(ng.y) * p_error.y + std::abs(ng.z) * p_error.z;
    const Vec3 offset = ng * (direction.dot(ng) < 0 ? -extent : extent);
    Vec3 origin = p + offset;
    for (int axis = 0; axis < 3; ++axis) {
        // The sum itself is rounded: one float further keeps it outside of the box.
        if (offset[axis] == 0) continue;
        const float sum = origin[axis];
        origin[axis] = sum == 0
                           ? std::copysign(std::numeric_limits<float>::denorm_min(), offset[axis])
                           : next_float(sum, (sum > 0) == (offset[axis] > 0));
    }
    return origin;
}

}  // namespace lxs
