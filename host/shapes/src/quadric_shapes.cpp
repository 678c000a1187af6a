// Spheres and disks.
#include <fmt/format.h>

#include <cmath>

#include "mesh_data.h"
#include "shape_factories.h"

namespace lxs {
namespace {

constexpr double kUnlimited = kLargestCoordinate;

ParameterDeclaration length(std::string_view name, std::string_view default_text,
                            std::string_view doc, double minimum) {
    return {name, ParameterType::Float, default_text, doc, minimum, kUnlimited};
}

ParameterDeclaration angle() {
    return {"phimax", ParameterType::Float, "360", "Angle around the z axis, degrees.", 0, 360};
}

ParameterDeclaration shape_name() {
    return {"name", ParameterType::String, "", "Name of the shape in messages."};
}

/// The number, which is finite and above zero; else InputError.
float positive(const ParameterReader& reader, std::string_view name, double fallback) {
    const auto value = static_cast<float>(reader.number(name, fallback));
    if (!(value > 0 && value <= kLargestCoordinate)) {
        reader.fail(name, fmt::format("\"{}\" is {}: expected a number above 0", name, value));
    }
    return value;
}

float finite(const ParameterReader& reader, std::string_view name, double fallback) {
    const auto value = static_cast<float>(reader.number(name, fallback));
    if (!(std::abs(value) <= kLargestCoordinate))
        reader.fail(name, fmt::format("\"{}\" is not finite: {}", name, value));
    return value;
}

void check_transform(const Matrix& to_world, const ParameterReader& reader) {
    bool affine =
        to_world[0][3] == 0 && to_world[1][3] == 0 && to_world[2][3] == 0 && to_world[3][3] == 1;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column)
            affine &= std::abs(to_world[row][column]) <= kUnlimited;
    }
    const double determinant = to_world.determinant();
    if (affine && std::isfinite(determinant) && determinant != 0) return;
    throw InputError(reader.where(),
                     fmt::format("the current transform can't be inverted or is not affine: a {} "
                                 "can't be placed with it",
                                 reader.plugin()));
}

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
        reader.fail("zmin", fmt::format("\"zmin\" {} and \"zmax\" {} leave nothing of a sphere of "
                                        "radius {}",
                                        z1, z2, sphere.radius));
    }
    sphere.phi_max = std::min(positive(reader, "phimax", 360), 360.0f);
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
        reader.fail("innerradius",
                    fmt::format("\"innerradius\" is {}: expected at least 0 and less "
                                "than the radius {}",
                                disk.inner_radius, disk.radius));
    }
    disk.phi_max = std::min(positive(reader, "phimax", 360), 360.0f);
    return Quadric{disk, to_world};
}

}  // namespace

ShapeFactory make_sphere_factory() {
    return {{length("radius", "1", "Radius.", 0),
             length("zmin", "-radius", "Where the sphere is cut off below.", -kUnlimited),
             length("zmax", "radius", "Where the sphere is cut off above.", -kUnlimited), angle(),
             shape_name()},
            create_sphere};
}

ShapeFactory make_disk_factory() {
    return {{length("height", "0", "Position on the z axis.", -kUnlimited),
             length("radius", "1", "Outer radius.", 0),
             length("innerradius", "0", "Radius of the hole.", 0), angle(), shape_name()},
            create_disk};
}

}  // namespace lxs
