// Maps of the unit square onto the shapes that lights sample, and their inverses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lxs/sdk/frame.h"
#include "lxs/sdk/light.h"
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

/// Azimuth about +z in turns, in [0, 1].
inline float turn_about_z(float x, float y) {
    // Adding zero drops the sign of zeros, on which the angle at the poles would hang.
    const float turn = std::atan2(y + 0.0f, x + 0.0f) / (2.0f * kPi);
    return turn < 0 ? turn + 1 : turn;
}

/// Inverse of around_z for a unit direction: 1 - cosine, and the azimuth in [0, 1).
inline Vec2 from_around_z(const Vec3& w) {
    const float one_minus_cos = w.z > 0 ? (w.x * w.x + w.y * w.y) / (1.0f + w.z) : 1.0f - w.z;
    return Vec2(one_minus_cos, clamp_to_unit(turn_about_z(w.x, w.y)));
}

/// Direction with density 1 / (4 pi). `u0` in double precision is as fine at -z as at +z: a float
/// just below 1 has so few bits left that what lies 30 m straight below a light met rings of
/// photons, millimetres wide.
inline Vec3 uniform_sphere(double u0, float u1) {
    const Vec3 w = around_z(static_cast<float>(2.0 * std::min(u0, 1.0 - u0)), u1);
    return u0 < 0.5 ? w : Vec3(w.x, w.y, -w.z);
}

/// Inverse of uniform_sphere for a unit direction, in [0, 1)^2.
inline Imath::V2d from_uniform_sphere(const Vec3& w) {
    const Vec2 u = from_around_z(Vec3(w.x, w.y, std::abs(w.z)));
    const double u0 = 0.5 * double(u.x);
    return Imath::V2d(clamp_to_unit(w.z < 0 ? 1.0 - u0 : u0), double(u.y));
}

/// Barycentric coordinates (of the second and third vertex) uniform over a triangle, without the
/// crease of the mirrored square (Heitz 2019, "A low-distortion map between triangle and square").
inline Vec2 uniform_triangle(float u0, float u1) {
    if (u1 > u0) return Vec2(u0 * 0.5f, u1 - u0 * 0.5f);
    return Vec2(u0 - u1 * 0.5f, u1 * 0.5f);
}

/// Inverse of uniform_triangle, in [0, 1)^2.
inline Vec2 from_uniform_triangle(const Vec2& b) {
    const float sum = b.x + b.y;
    return b.y > b.x ? Vec2(clamp_to_unit(2.0f * b.x), clamp_to_unit(sum))
                     : Vec2(clamp_to_unit(sum), clamp_to_unit(2.0f * b.y));
}

/// The value at `share` in [0, 1] of [low, high), never outside: what a CDF maps to that step.
inline float within_interval(float low, float high, float share) {
    return std::clamp(low + share * (high - low), low, std::nextafter(high, low));
}

/// Two of a photon's primary coordinates from `first` on, in single precision: for what is not far
/// wider than a view, or not the only number on which a photon's way depends.
inline Vec2 rounded_pair(const PrimaryPoint& u, std::size_t first) {
    return Vec2(clamp_to_unit(static_cast<float>(u[first])),
                clamp_to_unit(static_cast<float>(u[first + 1])));
}

/// Writes what was found in single precision into two of a photon's coordinates from `first` on. On
/// finer bits the photon does not depend: they stay spread out as the caller set them, so that no
/// cell of a guide becomes narrower than what one photon stands for.
inline void set_rounded_pair(PrimaryPoint& u, std::size_t first, const Vec2& found) {
    const Vec2 present = rounded_pair(u, first);
    for (int i = 0; i < 2; ++i) {
        double& x = u[first + static_cast<std::size_t>(i)];
        if (found[i] == present[i]) continue;  // or was not looked for
        x = clamp_to_unit(double(found[i]) + 0x1p-24 * (x - 0.5));
    }
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
