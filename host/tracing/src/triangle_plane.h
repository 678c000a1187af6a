// The plane of a triangle, worked out once per mesh instead of at every hit.
#pragma once

#include <cstdint>
#include <vector>

#include "lxs/scene/geometry.h"

namespace lxs {

/// 16 bytes a triangle.
struct TrianglePlane {
    Vec3 normal;  ///< unit, the surface's front
    float error;  ///< bound of how far off the plane the kernel sees the triangle, along the normal
};

/// [triangle]. The front is the side that corners run around counter-clockwise, or with `reversed`
/// the other. Degenerate triangles, which no ray meets, have no meaningful plane.
std::vector<TrianglePlane> triangle_planes(const TriangleMesh& mesh, bool reversed);

}  // namespace lxs
