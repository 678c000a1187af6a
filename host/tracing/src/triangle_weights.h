// Barycentric weights of hits where the kernel's single precision does not do: on triangles that
// are very small, or very large against the ray.
#pragma once

#include "embree_scene.h"

namespace lxs {

/// A triangle's first corner and the edges that start there.
struct CornerAndEdges {
    Imath::V3d corner, e1, e2;
};

/// Finds the weights again, in double precision, where the ray meets the triangle's plane, if the
/// kernel's are of no use. `origin` and `direction` are the ray's in the triangle's space.
///
/// Very small: Embree gives 0 and 0, and so corner 0, where four times the area that the ray sees
/// is below 1e-18. (A ray that really meets the corner is found there again.) Very large: the
/// weights' rounding displaces the hit by some 2^-24 of the triangle's size, which on a ground of
/// 500 km is 3 cm; the ray itself is known to 2^-24 of its length and its origin's coordinates.
void refine_weights(const CornerAndEdges& triangle, const Imath::V3d& origin,
                    const Imath::V3d& direction, RawHit& raw);

}  // namespace lxs
