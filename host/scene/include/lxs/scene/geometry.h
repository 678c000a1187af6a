// Shapes as plain data, before the tracer sees them.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Indexed triangles. Positions and normals are in the space of the enclosing object (world space
/// outside of ObjectBegin): the shape's own transform is already applied.
struct TriangleMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;           ///< per vertex, unit, or empty: flat shading
    std::vector<Vec2> uvs;               ///< per vertex or empty
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
};

/// Sphere of LuxRender/pbrt (z_min..z_max and phi_max in degrees cut it), around its own origin.
struct Sphere {
    float radius = 1;
    float z_min = -1, z_max = 1;
    float phi_max = 360;
};

/// Flat ring at z = height, normal +z.
struct Disk {
    float height = 0;
    float radius = 1, inner_radius = 0;
    float phi_max = 360;
};

/// An analytic shape and its transform to the enclosing object's (or world) space.
struct Quadric {
    std::variant<Sphere, Disk> shape;
    Matrix to_world;
};

using Geometry = std::variant<TriangleMesh, Quadric>;

}  // namespace lxs
