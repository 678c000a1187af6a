// Maps of the unit square onto the disk and the hemisphere, and their inverses.
// Source: Shirley & Chiu 1997, "A Low Distortion Map Between Disk and Square".
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lxs/sdk/sine_cosine.h"
#include "lxs/sdk/types.h"

namespace lxs {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kRadiansPerDegree = kPi / 180;
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

/// Point number `i` of `count` on the unit sphere, on a spiral and evenly spread.
inline Vec3 direction_on_sphere(int i, int count) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double phi = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    return {static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
            static_cast<float>(z)};
}

/// Area-preserving map of the square onto the sphere, unfolded as an octahedron: +z in the middle,
/// -z at the corners. Source: Clarberg 2008, "Fast equal-area mapping of the (hemi)sphere using
/// SIMD".
inline Imath::V3d square_to_equal_area_sphere(const Imath::V2d& u) {
    const double x = 2 * u.x - 1, y = 2 * u.y - 1;
    const double from_diagonal = 1 - (std::abs(x) + std::abs(y));
    const double r = 1 - std::abs(from_diagonal);
    const double turn = r > 0 ? (std::abs(y) - std::abs(x)) / r + 1 : 1;
    const double phi = turn * std::numbers::pi / 4;
    const double sine = r * std::sqrt(std::max(0.0, 2 - r * r));
    return {std::copysign(std::cos(phi), x) * sine, std::copysign(std::sin(phi), y) * sine,
            std::copysign(1 - r * r, from_diagonal)};
}

/// Direction about +z with density cos / pi (Malley's method).
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
    const Vec2 d = square_to_concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

/// Clamps to [0, 1), the range of primary coordinates; NaN becomes 0. `Real` is float or double.
template <class Real>
Real clamp_to_unit(Real x) {
    constexpr Real kBelowOne = 1 - std::numeric_limits<Real>::epsilon() / 2;
    return x > 0 ? std::min(x, kBelowOne) : 0;
}

/// Inverse of square_to_concentric_disk, in [0, 1)^2; points beyond the disk go to its edge.
template <class Real>
Imath::Vec2<Real> concentric_disk_to_square(const Imath::Vec2<Real>& d) {
    constexpr Real kHalf = 0.5;
    const Real radius = d.length();
    if (!(radius > 0)) return {kHalf, kHalf};
    const bool x_major = std::abs(d.x) > std::abs(d.y);
    const Real r = std::copysign(radius, x_major ? d.x : d.y);
    // The angle from the major axis, in units of 45 degrees, runs along the square's side.
    const Real along =
        std::atan(x_major ? d.y / d.x : d.x / d.y) * (4 / std::numbers::pi_v<Real>)*r;
    const Real x = x_major ? r : along, y = x_major ? along : r;
    return {clamp_to_unit(kHalf * (x + 1)), clamp_to_unit(kHalf * (y + 1))};
}

/// Inverse of square_to_cosine_hemisphere for a unit direction with z >= 0 (z is ignored).
inline Vec2 cosine_hemisphere_to_square(const Vec3& w) {
    return concentric_disk_to_square(Vec2(w.x, w.y));
}

}  // namespace lxs
