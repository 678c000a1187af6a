// Maps of the unit square onto the shapes that lights sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "lxs/sdk/types.h"

namespace lxs {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Orthonormal basis around a unit vector (Duff et al. 2017, "Building an orthonormal basis,
/// revisited").
struct Frame {
    Vec3 x, y, z;
    explicit Frame(const Vec3& n) : z(n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        x = Vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
        y = Vec3(b, sign + n.y * n.y * a, -n.y);
    }
    Vec3 to_world(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// Area-preserving map of the square onto the unit disk (Shirley & Chiu 1997).
inline Vec2 concentric_disk(float u0, float u1) {
    const float a = 2.0f * u0 - 1.0f, b = 2.0f * u1 - 1.0f;
    if (a == 0 && b == 0) return Vec2(0.0f);
    const bool wide = std::abs(a) > std::abs(b);
    const float r = wide ? a : b;
    const float phi = wide ? (kPi / 4) * (b / a) : kPi / 2 - (kPi / 4) * (a / b);
    return Vec2(r * std::cos(phi), r * std::sin(phi));
}

/// Direction about +z with density cos / pi (Malley's method).
inline Vec3 cosine_hemisphere(float u0, float u1) {
    const Vec2 d = concentric_disk(u0, u1);
    return Vec3(d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y)));
}

/// Direction about +z whose cosine is `1 - one_minus_cos`, at azimuth 2 pi u. The cosine comes as
/// its distance from 1 so that narrow cones keep their precision.
inline Vec3 around_z(float one_minus_cos, float u) {
    const float sin = std::sqrt(std::max(0.0f, one_minus_cos * (2.0f - one_minus_cos)));
    const float phi = 2.0f * kPi * u;
    return Vec3(sin * std::cos(phi), sin * std::sin(phi), 1.0f - one_minus_cos);
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
