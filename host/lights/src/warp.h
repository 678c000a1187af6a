// Maps of the unit square onto the shapes that lights sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lxs/sdk/frame.h"
#include "lxs/sdk/sine_cosine.h"
#include "lxs/sdk/warp.h"

namespace lxs {

/// Direction about +z whose cosine is `1 - one_minus_cos`, at azimuth 2 pi u. The cosine comes as
/// its distance from 1 so that narrow cones keep their precision.
inline Vec3 around_z(float one_minus_cos, float u) {
    const float sin = std::sqrt(std::max(0.0f, one_minus_cos * (2.0f - one_minus_cos)));
    const auto azimuth = sine_cosine_of_turn(u);
    return Vec3(sin * azimuth.cosine, sin * azimuth.sine, 1.0f - one_minus_cos);
}

/// Direction with density 1 / (4 pi).
inline Vec3 uniform_sphere(float u0, float u1) {
    return around_z(2.0f * u0, u1);
}

/// Barycentric coordinates (of the second and third vertex) uniform over a triangle, without the
/// crease of the mirrored square (Heitz 2019, "A low-distortion map between triangle and square").
inline Vec2 uniform_triangle(float u0, float u1) {
    if (u1 > u0) return Vec2(u0 * 0.5f, u1 - u0 * 0.5f);
    return Vec2(u0 - u1 * 0.5f, u1 * 0.5f);
}

/// Middle of cell `i` of a grid of side x side cells over the unit square.
inline Vec2 grid_center(std::size_t i, std::size_t side) {
    const std::size_t row = i / side, column = i % side;
    const float cell = 1.0f / static_cast<float>(side);
    return Vec2((static_cast<float>(column) + 0.5f) * cell,
                (static_cast<float>(row) + 0.5f) * cell);
}

/// Bound of the relative error of n roundings (Higham 2002, section 3.1).
constexpr float rounding_bound(int n) {
    constexpr float kUnit = std::numeric_limits<float>::epsilon() * 0.5f;
    return (static_cast<float>(n) * kUnit) / (1.0f - static_cast<float>(n) * kUnit);
}

}  // namespace lxs
