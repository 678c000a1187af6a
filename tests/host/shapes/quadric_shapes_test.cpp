// Spheres and disks: defaults, cuts, and the message for each way to get them wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shape_fixture.h"

namespace lxs::test::quadric_shapes_test {
namespace {

using testing::HasSubstr;

Quadric make_quadric(const std::string& plugin, std::vector<ParameterValue> values,
                     const Matrix& to_world = Matrix()) {
    RecordedDiagnostics diagnostics;
    return std::get<Quadric>(make_shape(plugin, std::move(values), diagnostics, to_world));
}

TEST(SphereShape, DefaultIsWhole) {
    const auto sphere = std::get<Sphere>(make_quadric("sphere", {}).shape);
    EXPECT_EQ(sphere.radius, 1);
    EXPECT_EQ(sphere.z_min, -1);
    EXPECT_EQ(sphere.z_max, 1);
    EXPECT_EQ(sphere.phi_max, 360);
    const auto large =
        std::get<Sphere>(make_quadric("sphere", {numbers("float", "radius", {2.5})}).shape);
    EXPECT_EQ(large.z_min, -2.5f);
    EXPECT_EQ(large.z_max, 2.5f);
}

TEST(SphereShape, CutsAreClampedAndOrdered) {
    const auto sphere = std::get<Sphere>(
        make_quadric("sphere", {numbers("float", "zmin", {0.5}), numbers("float", "zmax", {-7})})
            .shape);
    EXPECT_EQ(sphere.z_min, -1);
    EXPECT_EQ(sphere.z_max, 0.5f);
}

TEST(SphereShape, Errors) {
    EXPECT_THAT(error_of("sphere", {numbers("float", "radius", {0})}),
                HasSubstr("\"radius\" is 0: expected a number above 0"));
    EXPECT_NE(error_of("sphere", {numbers("float", "radius", {-1})}), "");
    EXPECT_NE(error_of("sphere", {numbers("float", "radius", {std::nan("")})}), "");
    EXPECT_THAT(error_of("sphere", {numbers("float", "zmin", {2}), numbers("float", "zmax", {3})}),
                HasSubstr("\"zmin\" 2 and \"zmax\" 3 leave nothing of a sphere of radius 1"));
    EXPECT_THAT(error_of("sphere", {}, Matrix().setScale(Imath::V3d(1, 0, 1))),
                HasSubstr("the current transform can't be inverted"));
}

TEST(DiskShape, DefaultsAndErrors) {
    const auto disk = std::get<Disk>(make_quadric("disk", {}).shape);
    EXPECT_EQ(disk.radius, 1);
    EXPECT_EQ(disk.inner_radius, 0);
    EXPECT_EQ(disk.height, 0);
    EXPECT_THAT(error_of("disk", {numbers("float", "innerradius", {1})}),
                HasSubstr("\"innerradius\" is 1: expected at least 0 and less than the radius 1"));
}

TEST(RevolutionShapes, Defaults) {
    const auto cylinder = std::get<RevolvedSegment>(make_quadric("cylinder", {}).shape);
    EXPECT_EQ(cylinder.start, Vec3(1, 0, -1));
    EXPECT_EQ(cylinder.end, Vec3(1, 0, 1));
    const auto cone = std::get<RevolvedSegment>(make_quadric("cone", {}).shape);
    EXPECT_EQ(cone.start, Vec3(1, 0, 0));
    EXPECT_EQ(cone.end, Vec3(0, 0, 1));
    const auto bowl = std::get<Paraboloid>(make_quadric("paraboloid", {}).shape);
    EXPECT_EQ(bowl.z_min, 0);
    EXPECT_EQ(bowl.height, 1);
    const auto hyperboloid = std::get<RevolvedSegment>(make_quadric("hyperboloid", {}).shape);
    EXPECT_EQ(hyperboloid.start, Vec3(0, 0, 0));
    EXPECT_EQ(hyperboloid.end, Vec3(1, 1, 1));
    const auto torus = std::get<Torus>(make_quadric("torus", {}).shape);
    EXPECT_EQ(torus.major_radius, 1);
    EXPECT_EQ(torus.minor_radius, 0.25f);
    EXPECT_EQ(torus.theta_max, 360);
}

TEST(RevolutionShapes, Errors) {
    EXPECT_THAT(error_of("cylinder", {numbers("float", "zmin", {1})}),
                HasSubstr("\"zmin\" and \"zmax\" are both 1"));
    EXPECT_THAT(error_of("cone", {numbers("float", "height", {0})}), HasSubstr("is a disk"));
    EXPECT_THAT(error_of("paraboloid", {numbers("float", "zmax", {-1})}),
                HasSubstr("opens upwards"));
    EXPECT_THAT(error_of("hyperboloid", {numbers("point", "p2", {1, 0, 0})}),
                HasSubstr("a flat ring is a disk with an"));
    EXPECT_NE(error_of("torus", {numbers("float", "thetamax", {0})}), "");
}

TEST(Quadrics, WithoutExtentAreEmpty) {
    using Values = std::vector<ParameterValue>;
    const std::vector<std::pair<std::string, Values>> shapes{
        {"sphere", {numbers("float", "radius", {0})}},
        {"sphere", {numbers("float", "phimax", {0})}},
        {"sphere", {numbers("float", "zmin", {2}), numbers("float", "zmax", {3})}},
        {"disk", {numbers("float", "innerradius", {2})}},
        {"cylinder", {numbers("float", "zmin", {1})}},
        {"cone", {numbers("float", "height", {0})}},
        {"hyperboloid", {numbers("point", "p2", {1, 0, 0})}},
        {"paraboloid", {numbers("float", "zmax", {0})}},
        {"torus", {numbers("float", "thetamax", {0})}}};
    for (const auto& [plugin, values] : shapes) {
        RecordedDiagnostics diagnostics;
        EXPECT_THROW(make_shape(plugin, values, diagnostics), EmptyShape) << plugin;
    }
}

}  // namespace
}  // namespace lxs::test::quadric_shapes_test
