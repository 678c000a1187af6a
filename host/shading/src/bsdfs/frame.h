// Local coordinates at a surface point and warps into them.
// Sources: Duff et al. 2017, "Building an Orthonormal Basis, Revisited"; Shirley & Chiu 1997.
#pragma once

#include <cmath>
#include <numbers>

#include "lxs/sdk/types.h"

namespace lxs::shading {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// Right-handed orthonormal basis; local z is the normal, local x the direction of the grain.
struct Frame {
    Vec3 s, t, n;

    /// Around a unit normal (Duff et al. 2017, listing 3).
    explicit Frame(const Vec3& normal) : n(normal) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        s = Vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
        t = Vec3(b, sign + n.y * n.y * a, -n.y);
    }
    /// With s along the part of `tangent` that is perpendicular to the unit normal, if there is
    /// one.
    Frame(const Vec3& normal, const Vec3& tangent) : Frame(normal) {
        const Vec3 along = tangent - n * tangent.dot(n);
        const float length = along.length();
        if (!(length > 1e-4f * tangent.length()) || !std::isfinite(length)) return;
        s = along / length;
        t = n.cross(s);
    }
    Vec3 to_world(const Vec3& v) const { return s * v.x + t * v.y + n * v.z; }
    Vec3 to_local(const Vec3& v) const { return {v.dot(s), v.dot(t), v.dot(n)}; }
};

/// True if `a` and `b` lie strictly on the same side of the plane with normal `n`.
inline bool same_side(const Vec3& a, const Vec3& b, const Vec3& n) {
    return a.dot(n) * b.dot(n) > 0;
}

/// `direction` mirrored at the unit normal `n`.
inline Vec3 reflect(const Vec3& direction, const Vec3& n) {
    return n * (2 * direction.dot(n)) - direction;
}

/// Cosine-distributed direction around +z (Shirley & Chiu 1997's concentric disk, projected up).
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
    const float x = 2 * u.x - 1, y = 2 * u.y - 1;
    if (x == 0 && y == 0) return {0, 0, 1};
    const bool x_major = std::abs(x) > std::abs(y);
    const float r = x_major ? x : y;
    const float phi = x_major ? (kPi / 4) * (y / x) : kPi / 2 - (kPi / 4) * (x / y);
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(0.0f, 1 - r * r))};
}

/// Draws wi with density |cos(wi, ns)| / pi over the geometric hemisphere of `wo`: directions
/// drawn around ns that fall below the geometric surface are replaced by their opposites, which
/// fill just the part of the hemisphere that ns leaves out. False if wo or wi grazes the surface.
inline bool sample_cosine(const Vec3& wo, const Vec3& ng, const Vec3& ns, const Vec2& u, Vec3& wi) {
    wi = Frame(ns).to_world(square_to_cosine_hemisphere(u));
    if (wi.dot(ng) * wo.dot(ng) < 0) wi = -wi;
    return same_side(wo, wi, ng) && wi.dot(ns) != 0;
}

}  // namespace lxs::shading
