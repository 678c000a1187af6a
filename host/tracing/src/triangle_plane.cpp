// Planes of triangles, with the kernel's rounding error.
#include "triangle_plane.h"

#include <algorithm>
#include <cmath>

#include "kernel_rounding.h"
#include "lxs/scene/on_all_threads.h"

namespace lxs {
namespace {

using Imath::V3d;

// The kernel (Embree's watertight test after Davidovic et al. 2012, "3D rasterization: a bridge
// between rasterization and ray casting") takes corners v_i relative to the origin, the normal N as
// a cross product of edges, and the distance as (v_0 . N) / (d . N). A ray that starts near the
// triangle must see the sign of v_0 . N right. Let w be the triangle's extents: |v_i| <= w and
// |edges| <= w hold per coordinate; subtracting the origin rounds by u w, so edges are off by at
// most 3u w, each component of N, a sum of two products, by 14u times the product of the two other
// extents. All summed, v_0 . N is off by at most 66u w_x w_y w_z (6 from v_0, 42 from N, 18 from
// the scalar product). Divided by |N| this is a distance along the normal. It is zero for triangles
// in a coordinate plane, for which the kernel is exact.
//
// The bound is the triangle's own. A coplanar neighbour that is larger by orders of magnitude and
// lies askew may still be met from within its own rounding error (u times its size) of the common
// edge; covering that would mean offsets by the largest triangle of a mesh everywhere.
constexpr double kPlaneError = 66 * kKernelRoundoff;

double plane_error(const V3d& e1, const V3d& e2, double inverse_normal_length) {
    double extents = kPlaneError * inverse_normal_length;
    for (int k = 0; k < 3; ++k) {
        extents *= std::max({0.0, e1[k], e2[k]}) - std::min({0.0, e1[k], e2[k]});
    }
    return extents;
}

}  // namespace

TrianglePlane triangle_plane(const V3d& e1, const V3d& e2, bool reversed) {
    const V3d normal = e1.cross(e2);
    const double inverse_length = 1 / std::sqrt(normal.dot(normal));
    return {Vec3(normal * (reversed ? -inverse_length : inverse_length)),
            static_cast<float>(plane_error(e1, e2, inverse_length))};
}

std::vector<TrianglePlane> triangle_planes(const TriangleMesh& mesh, bool reversed) {
    std::vector<TrianglePlane> planes(mesh.indices.size() / 3);
    in_pieces(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t* const corner = &mesh.indices[3 * i];
            const V3d p0(mesh.positions[corner[0]]);
            planes[i] = triangle_plane(V3d(mesh.positions[corner[1]]) - p0,
                                       V3d(mesh.positions[corner[2]]) - p0, reversed);
        }
    });
    return planes;
}

}  // namespace lxs
