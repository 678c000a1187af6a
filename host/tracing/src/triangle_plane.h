// The plane of a triangle: worked out once per mesh instead of at every hit, where that takes
// little memory.
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

/// Of the triangle with edges `e1` and `e2` from its first corner. Always the same bits.
TrianglePlane triangle_plane(const Imath::V3d& e1, const Imath::V3d& e2, bool reversed);

/// [triangle]. The front is the side that corners run around counter-clockwise, or with `reversed`
/// the other. Degenerate triangles, which no ray meets, have no meaningful plane.
std::vector<TrianglePlane> triangle_planes(const TriangleMesh& mesh, bool reversed);

}  // namespace lxs
