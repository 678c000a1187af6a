// Latitude-longitude coordinates of directions: t from +z (0) to -z (1), s the azimuth in turns.
#pragma once

#include <algorithm>
#include <cmath>

#include "lxs/sdk/warp.h"

namespace lxs {

/// Sine of the polar angle pi t; kept above zero because densities per solid angle divide by it.
inline float polar_sine(float t) {
    constexpr float kLeast = 1e-7f;
    return std::max(std::sin(kPi * t), kLeast);
}

/// Coordinates in [0, 1]^2 of a unit direction.
inline Vec2 latlong_coordinates(const Vec3& w) {
    const float s = std::atan2(w.y, w.x) / (2 * kPi);
    return Vec2(s < 0 ? s + 1 : s, std::acos(std::clamp(w.z, -1.0f, 1.0f)) / kPi);
}

/// Inverse of latlong_coordinates.
inline Vec3 latlong_direction(const Vec2& st) {
    const float phi = 2 * kPi * st.x, sine = polar_sine(st.y);
    return Vec3(sine * std::cos(phi), sine * std::sin(phi), std::cos(kPi * st.y));
}

/// Density per solid angle of a density over the unit square of coordinates.
inline float latlong_density(float over_square, float t) {
    return over_square / (2 * kPi * kPi * polar_sine(t));
}

}  // namespace lxs
