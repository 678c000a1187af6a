// Maps of the unit square onto the disk and the hemisphere.
// Source: Shirley & Chiu 1997, "A Low Distortion Map Between Disk and Square".
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/sdk/sine_cosine.h"
#include "lxs/sdk/types.h"

namespace lxs {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// Area-preserving map of the square onto the unit disk; `Real` is float or double.
template <class Real>
Imath::Vec2<Real> square_to_concentric_disk(const Imath::Vec2<Real>& u) {
    constexpr Real kQuarter = std::numbers::pi_v<Real> / 4;
    const Real x = 2 * u.x - 1, y = 2 * u.y - 1;
    if (x == 0 && y == 0) return {0, 0};
    const bool x_major = std::abs(x) > std::abs(y);
    const Real r = x_major ? x : y;
    // The angle from the axis that the point is nearest to.
    const auto angle = sine_cosine_of_octant(kQuarter * (x_major ? y / x : x / y));
    return x_major ? Imath::Vec2<Real>{r * angle.cosine, r * angle.sine}
                   : Imath::Vec2<Real>{r * angle.sine, r * angle.cosine};
}

/// Direction about +z with density cos / pi (Malley's method).
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
    const Vec2 d = square_to_concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

}  // namespace lxs
