// Frames and warps from the unit square, each with its density.
// Sources: Duff et al. 2017 (frame), Shirley & Chiu 1997 (concentric disk).
#pragma once

#include <numbers>

#include "aips/core/base/vector.h"

namespace aips {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// Right-handed orthonormal basis around a unit normal (Duff et al. 2017, listing 3).
struct Frame {
    Vec3 s, t, n;

    Frame(Vec3 tangent, Vec3 bitangent, Vec3 normal) : s(tangent), t(bitangent), n(normal) {}
    explicit Frame(Vec3 normal) : n(normal) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        s = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }
    /// The basis whose first tangent is the world axis after the normal's dominant one, made
    /// tangent: continuous over all normals with the same dominant direction (the one above jumps
    /// where n.z changes its sign), so that squares of directions stay aligned on curved surfaces.
    static Frame world_aligned(Vec3 normal) {
        const int axis = (dominant_axis(normal) + 1) % 3;
        Vec3 s = normal * -normal[axis];
        s[axis] += 1;
        s = normalize(s);
        return {s, cross(normal, s), normal};
    }

    Vec3 to_world(Vec3 v) const { return s * v.x + t * v.y + n * v.z; }
    Vec3 to_local(Vec3 v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
};

/// Area-preserving map of the unit square to the unit disk (Shirley & Chiu 1997).
inline Vec2 square_to_concentric_disk(Vec2 u) {
    const float x = 2 * u.x - 1, y = 2 * u.y - 1;
    if (x == 0 && y == 0) return {0, 0};
    const bool x_major = std::abs(x) > std::abs(y);
    const float r = x_major ? x : y;
    const float theta = x_major ? (kPi / 4) * (y / x) : kPi / 2 - (kPi / 4) * (x / y);
    return {r * std::cos(theta), r * std::sin(theta)};
}

/// Cosine-distributed direction around +z; density cos(theta) / pi per steradian.
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
    const Vec2 d = square_to_concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

/// Uniform direction on the sphere; density 1 / (4 pi) per steradian.
inline Vec3 square_to_uniform_sphere(Vec2 u) {
    const float z = 1 - 2 * u.x;
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    const float phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Largest float below 1: the end of the half-open unit interval.
inline constexpr float kBelowOne = 0x1.fffffep-1f;

/// Clamps to [0, 1); NaN becomes 0.
inline float clamp_to_unit(float x) {
    return x > 0 ? std::min(x, kBelowOne) : 0.0f;
}

/// Inverse of square_to_concentric_disk, in [0, 1)^2.
inline Vec2 concentric_disk_to_square(Vec2 d) {
    const bool x_major = std::abs(d.x) > std::abs(d.y);
    const float radius = std::sqrt(d.x * d.x + d.y * d.y);
    if (radius == 0) return {0.5f, 0.5f};
    const float r = std::copysign(radius, x_major ? d.x : d.y);
    // The angle from the major axis, in units of 45 degrees, runs along the square's side.
    const float along = (x_major ? std::atan(d.y / d.x) : std::atan(d.x / d.y)) * (4 / kPi) * r;
    const Vec2 square = x_major ? Vec2{r, along} : Vec2{along, r};
    return {clamp_to_unit(0.5f * (square.x + 1)), clamp_to_unit(0.5f * (square.y + 1))};
}

/// Inverse of square_to_cosine_hemisphere for a unit direction (z is ignored): the normal-aligned
/// cosine square, on which the uniform density is Lambert's. A density q on the square is
/// q * cos(theta) / pi per steradian.
inline Vec2 cosine_hemisphere_to_square(Vec3 w) {
    return concentric_disk_to_square({w.x, w.y});
}

/// Inverse of square_to_uniform_sphere for a unit direction: the cylindrical equal-area map. A
/// density q on the square is q / (4 pi) per steradian.
inline Vec2 uniform_sphere_to_square(Vec3 w) {
    // Adding zero drops the sign of zeros, on which the angle at the poles would hang.
    const float turn = std::atan2(w.y + 0.0f, w.x + 0.0f) * (0.5f * kInvPi);
    return {clamp_to_unit(0.5f * (1 - w.z)), clamp_to_unit(turn < 0 ? turn + 1 : turn)};
}

}  // namespace aips
