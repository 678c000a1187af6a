// Three-component vectors: points, directions, error bounds.
#pragma once

#include <algorithm>
#include <cmath>

namespace aips {

/// A point or direction in single precision; units are the scene's.
struct Vec3 {
    float x = 0, y = 0, z = 0;

    float operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    float& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator==(const Vec3&) const = default;
};

/// A point of the plane (primary sample coordinates in [0,1)^2, film positions in pixels).
struct Vec2 {
    float x = 0, y = 0;
    bool operator==(const Vec2&) const = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(Vec3 a) {
    return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(Vec3 a, float s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Vec3 operator*(float s, Vec3 a) {
    return a * s;
}
inline Vec3 operator/(Vec3 a, float s) {
    return a * (1.0f / s);
}
inline Vec3& operator+=(Vec3& a, Vec3 b) {
    return a = a + b;
}

inline float dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline float abs_dot(Vec3 a, Vec3 b) {
    return std::abs(dot(a, b));
}
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length_squared(Vec3 a) {
    return dot(a, a);
}
inline float length(Vec3 a) {
    return std::sqrt(dot(a, a));
}
/// Unit vector along `a`; `a` must not be zero.
inline Vec3 normalize(Vec3 a) {
    return a / length(a);
}
inline Vec3 abs(Vec3 a) {
    return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
inline Vec3 min(Vec3 a, Vec3 b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vec3 max(Vec3 a, Vec3 b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
/// Axis of the largest component by magnitude; of equals the first.
inline int dominant_axis(Vec3 a) {
    const Vec3 size = abs(a);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}
inline bool is_finite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace aips
