// Cylinders, cones, hyperboloids, paraboloids and tori.
#include <fmt/format.h>

#include <algorithm>

#include "empty_shape.h"
#include "quadric_parameters.h"
#include "shape_factories.h"

namespace lxs {
namespace {

Geometry create_cylinder(const ParameterReader& reader, const AssetContext& /*assets*/,
                         const Matrix& to_world) {
    check_transform(to_world, reader);
    const float radius = positive(reader, "radius", 1);
    const float z1 = finite(reader, "zmin", -1), z2 = finite(reader, "zmax", 1);
    if (z1 == z2) fail_empty(reader, "zmin", fmt::format("\"zmin\" and \"zmax\" are both {}", z1));
    return Quadric{RevolvedSegment{Vec3(radius, 0, std::min(z1, z2)),
                                   Vec3(radius, 0, std::max(z1, z2)), sweep_angle(reader)},
                   to_world};
}

Geometry create_cone(const ParameterReader& reader, const AssetContext& /*assets*/,
                     const Matrix& to_world) {
    check_transform(to_world, reader);
    const float radius = positive(reader, "radius", 1);
    const float top = finite(reader, "radius2", 0), height = finite(reader, "height", 1);
    if (top < 0) reader.fail("radius2", fmt::format("\"radius2\" is {}: expected at least 0", top));
    if (height == 0) fail_empty(reader, "height", "a cone of \"height\" 0 is a disk: use that");
    return Quadric{RevolvedSegment{Vec3(radius, 0, 0), Vec3(top, 0, height), sweep_angle(reader)},
                   to_world};
}

Geometry create_hyperboloid(const ParameterReader& reader, const AssetContext& /*assets*/,
                            const Matrix& to_world) {
    check_transform(to_world, reader);
    const Vec3 start = reader.vector("p1", Vec3(0.0f)), end = reader.vector("p2", Vec3(1.0f));
    check_position(start, {reader, "p1", "\"p1\""});
    check_position(end, {reader, "p2", "\"p2\""});
    if (start.z == end.z) {
        fail_empty(reader, "p2",
                   fmt::format("\"p1\" and \"p2\" are both at z = {}: a flat ring is a disk "
                               "with an \"innerradius\"",
                               end.z));
    }
    if (start.x == 0 && start.y == 0 && end.x == 0 && end.y == 0)
        fail_empty(reader, "p1",
                   "\"p1\" and \"p2\" both lie on the z axis: nothing to turn about it");
    return Quadric{RevolvedSegment{start, end, sweep_angle(reader)}, to_world};
}

Geometry create_paraboloid(const ParameterReader& reader, const AssetContext& /*assets*/,
                           const Matrix& to_world) {
    check_transform(to_world, reader);
    const float z1 = finite(reader, "zmin", 0), z2 = finite(reader, "zmax", 1);
    Paraboloid bowl;
    bowl.radius = positive(reader, "radius", 1);
    bowl.height = std::max(z1, z2);
    if (!(bowl.height > 0)) {
        fail_empty(reader, "zmax",
                   fmt::format("\"zmax\" is {}: the paraboloid opens upwards from 0", bowl.height));
    }
    bowl.z_min = std::max(std::min(z1, z2), 0.0f);
    if (bowl.z_min == bowl.height)
        fail_empty(reader, "zmin", fmt::format("\"zmin\" and \"zmax\" are both {}", bowl.height));
    bowl.phi_max = sweep_angle(reader);
    return Quadric{bowl, to_world};
}

/// An angle around the tube; as LuxRender does, brought into a turn that begins outside.
float tube_angle(const ParameterReader& reader, std::string_view name, double fallback) {
    const float given = finite(reader, name, fallback);
    const float angle = std::clamp(given, 0.0f, 360.0f);
    if (angle != given) {
        reader.diagnostics().warning(
            reader.where(name), fmt::format("\"{}\" goes from 0 to 360 degrees: {} is used for {}",
                                            name, angle, given));
    }
    return angle;
}

Geometry create_torus(const ParameterReader& reader, const AssetContext& /*assets*/,
                      const Matrix& to_world) {
    check_transform(to_world, reader);
    Torus torus;
    torus.major_radius = positive(reader, "majorradius", 1);
    torus.minor_radius = positive(reader, "minorradius", 0.25);
    const float theta1 = tube_angle(reader, "thetamin", 0);
    const float theta2 = tube_angle(reader, "thetamax", 360);
    torus.theta_min = std::min(theta1, theta2);
    torus.theta_max = std::max(theta1, theta2);
    if (torus.theta_min == torus.theta_max) {
        fail_empty(
            reader, "thetamin",
            fmt::format("\"thetamin\" {} and \"thetamax\" {} leave nothing", theta1, theta2));
    }
    torus.phi_max = sweep_angle(reader);
    return Quadric{torus, to_world};
}

ParameterDeclaration any_length(std::string_view name, std::string_view default_text,
                                std::string_view doc) {
    return length_parameter(name, default_text, doc, -kLargestLength);
}

}  // namespace

ShapeFactory make_cylinder_factory() {
    return {{length_parameter("radius", "1", "Radius.", 0),
             any_length("zmin", "-1", "Where the cylinder begins on the z axis."),
             any_length("zmax", "1", "Where it ends."), sweep_parameter(), name_parameter()},
            create_cylinder};
}

ShapeFactory make_cone_factory() {
    return {{length_parameter("radius", "1", "Radius at z = 0.", 0),
             length_parameter("radius2", "0", "Radius at z = height; above 0, a frustum.", 0),
             any_length("height", "1", "Position of the tip on the z axis."), sweep_parameter(),
             name_parameter()},
            create_cone};
}

ShapeFactory make_hyperboloid_factory() {
    return {{{"p1", ParameterType::Point, "0 0 0", "One end of the segment that turns about z."},
             {"p2", ParameterType::Point, "1 1 1", "Its other end."},
             sweep_parameter(),
             name_parameter()},
            create_hyperboloid};
}

ShapeFactory make_paraboloid_factory() {
    return {{length_parameter("radius", "1", "Radius at z = zmax.", 0),
             any_length("zmin", "0", "Where the paraboloid is cut off below; its vertex is at 0."),
             any_length("zmax", "1", "Where it is cut off above."), sweep_parameter(),
             name_parameter()},
            create_paraboloid};
}

ShapeFactory make_torus_factory() {
    using enum ParameterType;
    return {{length_parameter("majorradius", "1", "Radius of the circle inside of the tube.", 0),
             length_parameter("minorradius", "0.25", "Radius of the tube.", 0),
             {"thetamin", Float, "0", "Where the tube's round begins, degrees; 0 is outside."},
             {"thetamax", Float, "360", "Where the tube's round ends, degrees; 90 is the top."},
             sweep_parameter(),
             name_parameter()},
            create_torus};
}

}  // namespace lxs
