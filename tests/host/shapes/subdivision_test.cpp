// Loop subdivision against what is known of its limit surfaces, and displacement.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "shape_fixture.h"

namespace lxs::test::subdivision_test {
namespace {

using testing::HasSubstr;

ParameterValue octahedron_points() {
    return numbers("point", "P", {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1});
}

ParameterValue octahedron_faces() {
    return numbers("integer", "triindices",
                   {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5});
}

TEST(LoopSubdivision, ControlPointsGoToTheirLimit) {
    // Limit of a vertex with four neighbours: weights 1 / (n + 3 / (8 beta)) = 1/8 each, beta 3/32.
    for (const double levels : {1.0, 2.0, 3.0}) {
        const TriangleMesh mesh =
            make_mesh("mesh", {octahedron_points(), octahedron_faces(),
                               numbers("integer", "nsubdivlevels", {levels})});
        EXPECT_EQ(mesh.indices.size(), 24 * std::pow(4, levels));
        EXPECT_NEAR(mesh.positions[0].x, 0.5f, 1e-6f) << "at every level";
        EXPECT_NEAR(mesh.positions[4].z, 0.5f, 1e-6f);
        EXPECT_NEAR(mesh.normals[4].z, 1, 1e-6f);
    }
}

// The pole rows of a sphere made of quads: triangles of two places are no edge of the surface.
TEST(LoopSubdivision, CollapsedTrianglesLeaveTheSurfaceClosed) {
    std::vector<double> faces = std::get<0>(octahedron_faces().values);
    faces.insert(faces.end(), {4, 4, 0, 1, 4, 4, 0, 1, 0});
    const auto refined = [](const ParameterValue& indices) {
        return make_mesh("mesh",
                         {octahedron_points(), indices, numbers("integer", "nsubdivlevels", {2})});
    };
    const TriangleMesh plain = refined(octahedron_faces());
    const TriangleMesh mesh = refined(numbers("integer", "triindices", faces));
    EXPECT_EQ(mesh.indices, plain.indices);
    EXPECT_EQ(mesh.positions, plain.positions);
}

TEST(LoopSubdivision, NormalsAreThoseOfTheFineSurface) {
    const auto refined = [](double levels) {
        return make_mesh("loopsubdiv",
                         {octahedron_points(),
                          numbers("integer", "indices", std::get<0>(octahedron_faces().values)),
                          numbers("integer", "nlevels", {levels})});
    };
    const TriangleMesh mesh = refined(2), fine = refined(5);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        // Vertices keep their numbers: the same points, whose triangles are now small.
        EXPECT_LT((mesh.positions[i] - fine.positions[i]).length(), 1e-6f);
        EXPECT_GT(mesh.normals[i].dot(fine.normals[i]), 0.99999f);
        EXPECT_GT(mesh.normals[i].dot(mesh.positions[i].normalized()), 0.9f) << "outward";
    }
    for (std::size_t t = 0; t < fine.indices.size(); t += 3) {
        const Vec3& a = fine.positions[fine.indices[t]];
        const Vec3 n = (fine.positions[fine.indices[t + 1]] - a)
                           .cross(fine.positions[fine.indices[t + 2]] - a)
                           .normalized();
        const Vec3 mean = fine.normals[fine.indices[t]] + fine.normals[fine.indices[t + 1]] +
                          fine.normals[fine.indices[t + 2]];
        EXPECT_GT(n.dot(mean.normalized()), 0.99f);
    }
}

std::vector<ParameterValue> square() {
    return {numbers("point", "P", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}),
            numbers("integer", "triindices", {0, 1, 2, 0, 2, 3}),
            numbers("float", "uv", {0, 0, 1, 0, 1, 1, 0, 1})};
}

std::vector<ParameterValue> with(std::vector<ParameterValue> values, ParameterValue more) {
    values.push_back(std::move(more));
    return values;
}

double area(const TriangleMesh& mesh) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const Vec3& a = mesh.positions[mesh.indices[t]];
        sum += 0.5 * (mesh.positions[mesh.indices[t + 1]] - a)
                         .cross(mesh.positions[mesh.indices[t + 2]] - a)
                         .length();
    }
    return sum;
}

TEST(LoopSubdivision, BoundariesAreRoundedUnlessSharp) {
    const auto levels = numbers("integer", "nsubdivlevels", {3});
    const TriangleMesh round = make_mesh("mesh", with(square(), levels));
    const TriangleMesh sharp =
        make_mesh("mesh", with(with(square(), levels), flag("dmsharpboundary", true)));
    // The boundary is the uniform cubic B-spline of the four corners.
    EXPECT_NEAR(round.positions[0].x, 1.0 / 6, 1e-6);
    EXPECT_LT(area(round), 0.9);
    EXPECT_NEAR(area(sharp), 1, 1e-6);
    EXPECT_EQ(sharp.positions[0], Vec3(0.0f));
    for (std::size_t i = 0; i < sharp.normals.size(); ++i) {
        EXPECT_NEAR(sharp.normals[i].z, 1, 1e-6f);
        EXPECT_NEAR(round.normals[i].z, 1, 1e-6f);
    }
}

TEST(LoopSubdivision, SeamsOfCoordinatesStayClosed) {
    // The square as two triangles that share no vertex: one surface by place, two by coordinates.
    const std::vector<ParameterValue> apart = {
        numbers("point", "P", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}),
        numbers("integer", "triindices", {0, 1, 2, 3, 4, 5}),
        numbers("float", "uv", {0, 0, 1, 0, 1, 1, 5, 5, 6, 6, 5, 6}),
        numbers("integer", "nsubdivlevels", {2})};
    const TriangleMesh together =
        make_mesh("mesh", with(square(), numbers("integer", "nsubdivlevels", {2})));
    const TriangleMesh merged = make_mesh("mesh", apart);
    EXPECT_NEAR(area(merged), area(together), 1e-6);
    EXPECT_EQ(merged.uvs[3], Vec2(5, 5));
    const TriangleMesh split = make_mesh("mesh", with(apart, flag("dmnormalsplit", true)));
    EXPECT_LT(area(split), 0.99 * area(together)) << "each part shrinks by itself";
}

TEST(Microdisplacement, SplitsWithoutSmoothing) {
    const TriangleMesh mesh =
        make_mesh("mesh", with(with(square(), text("subdivscheme", "microdisplacement")),
                               numbers("integer", "nsubdivlevels", {6})));
    EXPECT_EQ(mesh.indices.size(), 6u * 64) << "6 parts are made 8";
    EXPECT_NEAR(area(mesh), 1, 1e-6);
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
}

/// The shape displaced by the fixture's texture "bumps", whose value is u.
std::vector<ParameterValue> displaced(bool smooth) {
    auto values = with(square(), numbers("integer", "nsubdivlevels", {8}));
    values = with(values, text("subdivscheme", "microdisplacement"));
    values =
        with(values, {"texture", "displacementmap", std::vector<std::string>{"bumps"}, {}, {}});
    values = with(values, numbers("float", "dmscale", {0.5}));
    values = with(values, numbers("float", "dmoffset", {0.25}));
    return with(values, flag("dmnormalsmooth", smooth));
}

TEST(Displacement, MovesAlongTheNormals) {
    const TriangleMesh mesh = make_mesh("mesh", displaced(true));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(mesh.positions[i].z, 0.25f + 0.5f * mesh.uvs[i].x, 1e-6f);
        EXPECT_NEAR(mesh.positions[i].x, mesh.uvs[i].x, 1e-6f);
        EXPECT_NEAR(mesh.normals[i].z, 1 / std::sqrt(1.25f), 1e-5f);
    }
    EXPECT_TRUE(make_mesh("mesh", displaced(false)).normals.empty()) << "flat triangles";
}

TEST(Subdivision, RefusesUnknownSchemes) {
    EXPECT_THAT(error_of("mesh", with(square(), text("subdivscheme", "catmull"))),
                HasSubstr("catmull"));
}

}  // namespace
}  // namespace lxs::test::subdivision_test
