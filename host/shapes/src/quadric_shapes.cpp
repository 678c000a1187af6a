// Spheres and disks.
#include <fmt/format.h>

#include <algorithm>

#include "empty_shape.h"
#include "quadric_parameters.h"
#include "shape_factories.h"

namespace lxs {
namespace {

Geometry create_sphere(const ParameterReader& reader, const AssetContext& /*assets*/,
                       const Matrix& to_world) {
    check_transform(to_world, reader);
    Sphere sphere;
    sphere.radius = positive(reader, "radius", 1);
    const float z1 = finite(reader, "zmin", -sphere.radius);
    const float z2 = finite(reader, "zmax", sphere.radius);
    sphere.z_min = std::clamp(std::min(z1, z2), -sphere.radius, sphere.radius);
    sphere.z_max = std::clamp(std::max(z1, z2), -sphere.radius, sphere.radius);
    if (sphere.z_min == sphere.z_max) {
        fail_empty(reader, "zmin",
                   fmt::format("\"zmin\" {} and \"zmax\" {} leave nothing of a sphere of "
                               "radius {}",
                               z1, z2, sphere.radius));
    }
    sphere.phi_max = sweep_angle(reader);
    return Quadric{sphere, to_world};
}

Geometry create_disk(const ParameterReader& reader, const AssetContext& /*assets*/,
                     const Matrix& to_world) {
    check_transform(to_world, reader);
    Disk disk;
    disk.height = finite(reader, "height", 0);
    disk.radius = positive(reader, "radius", 1);
    disk.inner_radius = finite(reader, "innerradius", 0);
    if (!(disk.inner_radius >= 0 && disk.inner_radius < disk.radius)) {
        fail_empty(reader, "innerradius",
                   fmt::format("\"innerradius\" is {}: expected at least 0 and less "
                               "than the radius {}",
                               disk.inner_radius, disk.radius));
    }
    disk.phi_max = sweep_angle(reader);
    return Quadric{disk, to_world};
}

}  // namespace

ShapeFactory make_sphere_factory() {
    return {
        {length_parameter("radius", "1", "Radius.", 0),
         length_parameter("zmin", "-radius", "Where the sphere is cut off below.", -kLargestLength),
         length_parameter("zmax", "radius", "Where the sphere is cut off above.", -kLargestLength),
         sweep_parameter(), name_parameter()},
        create_sphere};
}

ShapeFactory make_disk_factory() {
    return {{length_parameter("height", "0", "Position on the z axis.", -kLargestLength),
             length_parameter("radius", "1", "Outer radius.", 0),
             length_parameter("innerradius", "0", "Radius of the hole.", 0), sweep_parameter(),
             name_parameter()},
            create_disk};
}

}  // namespace lxs
