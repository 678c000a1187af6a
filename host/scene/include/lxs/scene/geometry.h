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
    std::vector<Rgb> colors;             ///< per vertex or empty
    std::vector<float> alphas;           ///< opacity per vertex or empty
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

/// The segment from `start` (at azimuth 0) to `end`, turned about the z axis: a cylinder, a cone,
/// or, where the segment is askew to the axis, a hyperboloid of one sheet. The ends differ in z.
struct RevolvedSegment {
    Vec3 start{1, 0, 0}, end{1, 0, 1};
    float phi_max = 360;
};

/// z = height * (x^2 + y^2) / radius^2 between z_min and height, z_min >= 0.
struct Paraboloid {
    float radius = 1;
    float z_min = 0, height = 1;
    float phi_max = 360;
};

/// A tube of minor_radius around the circle of major_radius in the plane z = 0, from theta_min to
/// theta_max around the tube (degrees; 0 is the outside, 90 the top).
struct Torus {
    float major_radius = 1, minor_radius = 0.25f;
    float theta_min = 0, theta_max = 360;
    float phi_max = 360;
};

/// An analytic shape and its transform to the enclosing object's (or world) space.
struct Quadric {
    std::variant<Sphere, Disk, RevolvedSegment, Paraboloid, Torus> shape;
    Matrix to_world;
};

using Geometry = std::variant<TriangleMesh, Quadric>;

}  // namespace lxs
