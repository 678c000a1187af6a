// Meshes written out in a scene: what they become, and the message for each way to get them wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "shape_fixture.h"

namespace lxs::test::mesh_shape_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const ParameterValue kSquare = numbers("point", "P", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
const ParameterValue kTwoTriangles = numbers("integer", "triindices", {0, 1, 2, 0, 2, 3});

TEST(MeshShape, AllNamesMakeTheSameMesh) {
    for (const char* name : {"mesh", "trianglemesh", "barytrianglemesh", "waldtrianglemesh"}) {
        const TriangleMesh mesh = make_mesh(name, {kSquare, kTwoTriangles});
        EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3)) << name;
        EXPECT_EQ(mesh.positions.size(), 4u);
        EXPECT_TRUE(mesh.normals.empty());
        EXPECT_TRUE(mesh.uvs.empty());
    }
}

TEST(MeshShape, OlderNamesOfLists) {
    const TriangleMesh mesh =
        make_mesh("trianglemesh", {kSquare, numbers("integer", "indices", {0, 1, 2}),
                                   numbers("float", "st", {0, 0, 1, 0, 1, 1, 0, 1})});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(mesh.uvs.at(2), Vec2(1, 1));
}

TEST(MeshShape, TodaysNamesCountBesideOlderOnes) {
    RecordedDiagnostics diagnostics;
    const auto mesh = std::get<TriangleMesh>(make_shape(
        "mesh", {kSquare, numbers("integer", "indices", {0, 1, 2}), kTwoTriangles}, diagnostics));
    EXPECT_EQ(mesh.indices.size(), 6u);
    EXPECT_THAT(diagnostics.warnings,
                ElementsAre("mesh: \"triindices\" is used in place of \"indices\""));
    EXPECT_THAT(diagnostics.lines, ElementsAre(3u));
}

TEST(MeshShape, WithoutExtentIsEmpty) {
    const ParameterValue line = numbers("point", "P", {0, 0, 0, 1, 0, 0, 2, 0, 0});
    const ParameterValue triangle = numbers("integer", "indices", {0, 1, 2});
    RecordedDiagnostics diagnostics;
    EXPECT_THROW(make_shape("mesh", {line, triangle}, diagnostics), EmptyShape);
    EXPECT_THROW(make_shape("mesh", {numbers("point", "P", {}), triangle}, diagnostics),
                 EmptyShape);
    EXPECT_THROW(make_shape("mesh", {line, numbers("integer", "indices", {})}, diagnostics),
                 EmptyShape);
}

TEST(MeshShape, QuadrilateralsBecomeTwoTriangles) {
    const TriangleMesh mesh =
        make_mesh("mesh", {kSquare, numbers("integer", "quadindices", {0, 1, 2, 3})});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST(MeshShape, IsTransformed) {
    const Matrix m =
        Matrix().setScale(Imath::V3d(1, 1, 2)) * Matrix().setTranslation(Imath::V3d(0, 0, 5));
    const TriangleMesh mesh = make_mesh("mesh",
                                        {numbers("point", "P", {0, 0, 0, 1, 0, 1, 0, 1, 0}),
                                         numbers("integer", "triindices", {0, 1, 2}),
                                         numbers("normal", "N", {-1, 0, 1, -1, 0, 1, -3, 0, 3})},
                                        m);
    EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 7));
    for (const Vec3& n : mesh.normals) {
        EXPECT_NEAR(n.x, -2 / std::sqrt(5.0f), 1e-6f);
        EXPECT_NEAR(n.z, 1 / std::sqrt(5.0f), 1e-6f);
    }
}

TEST(MeshShape, MirroringKeepsNormalsOnTheirSide) {
    const TriangleMesh mesh = make_mesh(
        "mesh",
        {kSquare, kTwoTriangles, numbers("normal", "N", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
        Matrix().setScale(Imath::V3d(-1, 1, 1)));
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
}

TEST(MeshShape, ZeroNormalsBecomeGeometric) {
    const TriangleMesh mesh = make_mesh(
        "mesh",
        {kSquare, kTwoTriangles, numbers("normal", "N", {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0})});
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], Vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[2], Vec3(0, 0, 1));
}

TEST(MeshShape, DegenerateTrianglesAreDroppedAndCounted) {
    RecordedDiagnostics diagnostics;
    const Geometry geometry =
        make_shape("mesh",
                   {numbers("point", "P", {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0}),
                    numbers("integer", "triindices", {0, 1, 2, 0, 1, 3, 3, 3, 1})},
                   diagnostics);
    EXPECT_THAT(std::get<TriangleMesh>(geometry).indices, ElementsAre(0, 1, 3));
    EXPECT_THAT(diagnostics.warnings, ElementsAre("2 triangles without area left out"));
}

TEST(MeshShape, SmallTrianglesAreNotDegenerate) {
    const TriangleMesh mesh = make_mesh("mesh", {kSquare, kTwoTriangles},
                                        Matrix().setScale(Imath::V3d(1e-12, 1e-12, 1e-12)));
    EXPECT_EQ(mesh.indices.size(), 6u);
}

TEST(MeshShape, VertexColoursAndOpacities) {
    const std::vector<ParameterValue> values = {
        kSquare, kTwoTriangles, numbers("color", "C", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, 0.5}),
        numbers("float", "alpha", {1, 0.5, 0.25, 0}), numbers("float", "gamma", {2})};
    const TriangleMesh mesh = make_mesh("mesh", values);
    EXPECT_EQ(mesh.colors.at(2), Rgb(0, 0, 1));
    EXPECT_EQ(mesh.colors.at(3), Rgb(0.25f));
    EXPECT_EQ(mesh.alphas.at(1), 0.5f);
}

TEST(HeightField, CoversTheUnitSquare) {
    const TriangleMesh mesh =
        make_mesh("heightfield", {numbers("integer", "nu", {3}), numbers("integer", "nv", {2}),
                                  numbers("float", "Pz", {0, 1, 2, 3, 4, 5})});
    EXPECT_EQ(mesh.indices.size(), 12u);
    EXPECT_EQ(mesh.positions.at(1), Vec3(0.5f, 0, 1));
    EXPECT_EQ(mesh.positions.at(5), Vec3(1, 1, 5));
    EXPECT_EQ(mesh.uvs.at(4), Vec2(0.5f, 1));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4)) << "front is up";
    EXPECT_THAT(
        error_of("heightfield", {numbers("integer", "nu", {3}), numbers("integer", "nv", {2}),
                                 numbers("float", "Pz", {0, 1, 2})}),
        HasSubstr("\"Pz\" has 3 values: expected nu * nv = 3 * 2"));
}

TEST(MeshShape, AcceptsLuxRendersParametersAndCatchesMisspelling) {
    RecordedDiagnostics diagnostics;
    make_shape("mesh", {kSquare, kTwoTriangles, text("name", "floor")}, diagnostics);
    EXPECT_TRUE(diagnostics.warnings.empty());
    make_shape("mesh", {kSquare, kTwoTriangles, flag("generatetangent", false)}, diagnostics);
    EXPECT_EQ(diagnostics.warnings.size(), 1u);
    EXPECT_THAT(diagnostics.warnings[0], HasSubstr("generatetangents"));
}

TEST(MeshShapeErrors, MissingPositions) {
    EXPECT_THAT(error_of("mesh", {kTwoTriangles}),
                HasSubstr("a mesh needs vertex positions: \"point P\" [...]"));
}

TEST(MeshShapeErrors, MissingTriangles) {
    EXPECT_THAT(error_of("mesh", {kSquare}),
                HasSubstr("a mesh needs triangles: \"integer triindices\" [...]"));
}

TEST(MeshShapeErrors, IndexOutOfRange) {
    EXPECT_THAT(
        error_of("mesh", {kSquare, numbers("integer", "triindices", {0, 1, 2, 0, 9, 3})}),
        HasSubstr("\"triindices\" names vertex 9 at position 4 (triangle 1), but \"P\" has 4 "
                  "vertices, numbered from 0"));
    EXPECT_THAT(error_of("mesh", {kSquare, numbers("integer", "triindices", {0, -1, 2})}),
                HasSubstr("names vertex -1 at position 1 (triangle 0)"));
    EXPECT_THAT(error_of("mesh", {kSquare, numbers("integer", "quadindices", {0, 1, 2, 4})}),
                HasSubstr("\"quadindices\" names vertex 4 at position 3 (quadrilateral 0)"));
}

TEST(MeshShapeErrors, CountsThatDoNotFit) {
    EXPECT_THAT(error_of("mesh", {kSquare, numbers("integer", "triindices", {0, 1, 2, 0})}),
                HasSubstr("\"triindices\" has 4 values, which is not a multiple of 3"));
}

// As in LuxRender: the attribute goes, the mesh stays.
TEST(MeshShape, AttributesThatDoNotFitTheVerticesAreLeftOut) {
    struct Case {
        ParameterValue attribute;
        std::string message;
    };
    const std::vector<Case> cases = {
        {numbers("normal", "N", {0, 0, 1}),
         "\"N\" has 3 values, but \"P\" has 4 vertices: expected 12"},
        {numbers("float", "uv", {0, 0, 1}),
         "\"uv\" has 3 values, but \"P\" has 4 vertices: expected 8"},
        {numbers("float", "st", {0, 0, 1, 1}),
         "\"st\" has 4 values, but \"P\" has 4 vertices: expected 8"},
        {numbers("color", "C", {1, 0, 0}),
         "\"C\" has 3 values, but \"P\" has 4 vertices: expected 12"},
        {numbers("float", "alpha", {1, 1, 1, 1, 1}),
         "\"alpha\" has 5 values, but \"P\" has 4 vertices: expected 4"},
        {numbers("float", "A", {1}), "\"A\" has 1 values, but \"P\" has 4 vertices: expected 4"}};
    for (const char* plugin : {"mesh", "trianglemesh", "barytrianglemesh", "waldtrianglemesh"}) {
        for (const Case& wrong : cases) {
            RecordedDiagnostics diagnostics;
            diagnostics.lenient = true;
            const auto mesh = std::get<TriangleMesh>(
                make_shape(plugin, {kSquare, kTwoTriangles, wrong.attribute}, diagnostics));
            EXPECT_EQ(mesh.indices.size(), 6u) << plugin;
            EXPECT_TRUE(mesh.normals.empty() && mesh.uvs.empty() && mesh.colors.empty() &&
                        mesh.alphas.empty());
            EXPECT_THAT(diagnostics.warnings, ElementsAre(wrong.message + "; it is left out"));
            EXPECT_THAT(diagnostics.lines, ElementsAre(4u)) << "at the attribute";
        }
    }
    for (const Case& wrong : cases) {
        RecordedDiagnostics diagnostics;
        diagnostics.lenient = true;
        const auto mesh = std::get<TriangleMesh>(
            make_shape("loopsubdiv", {kSquare, kTwoTriangles, wrong.attribute}, diagnostics));
        EXPECT_EQ(mesh.indices.size(), 6u * 64) << "three levels of subdivision";
        EXPECT_THAT(diagnostics.warnings, ElementsAre(wrong.message + "; it is left out"));
    }
}

TEST(MeshShape, ValuesThatAreNoNumbersAreReplaced) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    RecordedDiagnostics diagnostics;
    diagnostics.lenient = true;
    const auto mesh = std::get<TriangleMesh>(make_shape(
        "mesh",
        {kSquare, kTwoTriangles,
         numbers("normal", "N", {1, 0, 0, 0, kInfinity, 0, std::nan(""), 0, 0, 0, 1e30, 0}),
         numbers("float", "uv", {1, 1, 0, kInfinity, 1, 0, 0, 1}),
         numbers("color", "C", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, 1e99}),
         numbers("float", "alpha", {0, 0.5, kInfinity, 0.25})},
        diagnostics));
    EXPECT_THAT(mesh.normals,
                ElementsAre(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 1, 0)));
    EXPECT_THAT(mesh.uvs, ElementsAre(Vec2(1, 1), Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)));
    EXPECT_THAT(mesh.colors, ElementsAre(Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(1, 1, 1)));
    EXPECT_THAT(mesh.alphas, ElementsAre(0, 0.5f, 1, 0.25f));
    EXPECT_THAT(
        diagnostics.warnings,
        ElementsAre("normal 1 of \"N\" and 1 more are not finite; the mean of the triangles "
                    "there is used",
                    "pair 1 of \"uv\" is not finite; 0 0 is used",
                    "colour 3 of \"C\" is not finite; white is used",
                    "opacity 2 of \"alpha\" is not finite; 1 is used"));
    EXPECT_THAT(diagnostics.lines, ElementsAre(4u, 5u, 6u, 7u));
}

TEST(MeshShape, TrianglesWithAVertexThatIsNoPlaceAreLeftOut) {
    const ParameterValue points = numbers("point", "P", {0, 0, 0, 1, 0, 0, 1, 1, 0, 2e18, 1, 0});
    RecordedDiagnostics diagnostics;
    diagnostics.lenient = true;
    const auto mesh =
        std::get<TriangleMesh>(make_shape("mesh", {points, kTwoTriangles}, diagnostics));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_LE(mesh.positions.at(3).x, 1) << "boxes around all vertices stay small";
    EXPECT_THAT(
        diagnostics.warnings,
        ElementsAre("vertex 3 of \"P\" is beyond 1e+18: (2e+18, 1, 0); 1 triangle with such "
                    "a vertex is left out"));
    RecordedDiagnostics silent;
    silent.lenient = true;
    make_shape("mesh", {points, numbers("integer", "triindices", {0, 1, 2})}, silent);
    EXPECT_THAT(silent.warnings, testing::IsEmpty()) << "no triangle uses it";
    RecordedDiagnostics heights;
    heights.lenient = true;
    const auto field = std::get<TriangleMesh>(
        make_shape("heightfield",
                   {numbers("integer", "nu", {3}), numbers("integer", "nv", {2}),
                    numbers("float", "Pz", {0, 1, 1e99, 3, 4, 5})},
                   heights));
    EXPECT_EQ(field.indices.size(), 9u) << "the corner touches one triangle of four";
    EXPECT_EQ(heights.warnings.size(), 1u);
}

TEST(MeshShapeErrors, NumbersThatAreNone) {
    const ParameterValue one = numbers("integer", "triindices", {0, 1, 2});
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THAT(error_of("mesh", {numbers("point", "P", {0, 0, 0, 1, infinity, 0, 0, 1, 0}), one}),
                HasSubstr("vertex 1 of \"P\" is not finite: (1, inf, 0)"));
    EXPECT_THAT(error_of("mesh", {numbers("point", "P", {0, 0, 0, 1, 1e200, 0, 0, 1, 0}), one}),
                HasSubstr("vertex 1 of \"P\" is not finite: (1, inf, 0)"));
    EXPECT_THAT(error_of("mesh", {numbers("point", "P", {0, 0, 0, 1, 2e18, 0, 0, 1, 0}), one}),
                HasSubstr("vertex 1 of \"P\" is beyond 1e+18"));
    EXPECT_THAT(
        error_of("mesh", {numbers("point", "P", {0, 0, 0, 1, std::nan(""), 0, 0, 1, 0}), one}),
        HasSubstr("vertex 1 of \"P\" is not finite: (1, nan, 0)"));
}

TEST(MeshShapeErrors, TransformOutOfRange) {
    EXPECT_THAT(
        error_of("mesh", {kSquare, kTwoTriangles}, Matrix().setScale(Imath::V3d(1e30, 1, 1))),
        HasSubstr("the current transform moves vertex 1 out of range"));
}

TEST(MeshShapeErrors, StandAtTheParameter) {
    EXPECT_THAT(error_of("mesh", {kSquare, numbers("integer", "triindices", {0, 1, 7})}),
                testing::StartsWith("scene.lxs:3:1: error: \"triindices\" names vertex 7"));
    EXPECT_THAT(error_of("mesh", {kSquare}), testing::StartsWith("scene.lxs:1:1: error: "));
}

}  // namespace
}  // namespace lxs::test::mesh_shape_test
