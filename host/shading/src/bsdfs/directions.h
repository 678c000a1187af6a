// Directions about a surface: sides, mirror image, cosine-distributed draws.
#pragma once

#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"

namespace lxs::shading {

/// Least cosine that is divided by: less is a direction that grazes.
inline constexpr float kMinCosine = 1e-6f;

/// True if `a` and `b` lie strictly on the same side of the plane with normal `n`.
inline bool same_side(const Vec3& a, const Vec3& b, const Vec3& n) {
    return a.dot(n) * b.dot(n) > 0;
}

/// `direction` mirrored at the unit normal `n`.
inline Vec3 reflect(const Vec3& direction, const Vec3& n) {
    return n * (2 * direction.dot(n)) - direction;
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
