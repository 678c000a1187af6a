// Local coordinates at a surface or around an axis.
// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
#pragma once

#include <cmath>

#include "lxs/sdk/types.h"

namespace lxs {

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

}  // namespace lxs
