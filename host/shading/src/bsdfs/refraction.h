// Snell's law.
#pragma once

#include <algorithm>
#include <cmath>

#include "lxs/sdk/types.h"

namespace lxs::shading {

/// Direction into which light from `wo` (pointing away from the surface) is bent; `n` on its side,
/// `eta` = index behind the surface / index on wo's side. Not for total internal reflection.
inline Vec3 refract(const Vec3& wo, const Vec3& n, float eta) {
    const float cos_o = wo.dot(n);
    const float cos_t = std::sqrt(std::max(0.0f, 1 - (1 - cos_o * cos_o) / (eta * eta)));
    return (n * (cos_o / eta - cos_t) - wo / eta).normalized();
}

}  // namespace lxs::shading
