// Meshes in PLY files: text and binary, with and without normals and coordinates, damaged ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "shape_fixture.h"
#include "temporary_folder.h"

namespace lxs::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PlyShape : public testing::Test {
  protected:
    std::string write(const std::string& content) const {
        return folder_.write("mesh.ply", content);
    }
    static std::string header(const std::string& format, int vertices,
                              const std::string& properties, int faces) {
        return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
               "\nproperty float x\nproperty float y\nproperty float z\n" + properties +
               "element face " + std::to_string(faces) +
               "\nproperty list uchar uint vertex_indices\nend_header\n";
    }

  private:
    files::TemporaryFolder folder_;
};

const std::string normals_and_coordinates =
    "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n";

TEST_F(PlyShape, BinaryAsLuxBlendWritesIt) {
    std::string content = header("binary_little_endian", 4, normals_and_coordinates, 1);
    const float vertices[4][8] = {{0, 0, 0, 0, 0, 1, 0.25f, 0.5f},
                                  {1, 0, 0, 0, 0, 1, 1, 0},
                                  {1, 1, 0, 0, 0.6f, 0.8f, 1, 0.75f},
                                  {0, 1, 0, 0, 0, 1, 0, 1}};
    content.append(reinterpret_cast<const char*>(vertices), sizeof vertices);
    const std::uint32_t corners[4] = {0, 1, 2, 3};
    content.push_back(4);
    content.append(reinterpret_cast<const char*>(corners), sizeof corners);
    const TriangleMesh mesh = make_mesh("plymesh", {text("filename", write(content))});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_EQ(mesh.positions.at(2), Vec3(1, 1, 0));
    EXPECT_NEAR(mesh.normals.at(2).y, 0.6f, 1e-6f);
    EXPECT_EQ(mesh.uvs.at(0), Vec2(0.25f, 0.5f));
    EXPECT_EQ(mesh.uvs.at(2), Vec2(1, 0.75f));
}

const std::string roof =  // two faces with a common ridge, no normals
    "-1 0 0\n0 0 1\n0 1 1\n-1 1 0\n1 0 0\n1 1 0\n4 0 1 2 3\n4 1 4 5 2\n";

TEST_F(PlyShape, WithoutNormalsItIsSmooth) {
    const TriangleMesh mesh =
        make_mesh("plymesh", {text("filename", write(header("ascii", 6, "", 2) + roof))});
    ASSERT_EQ(mesh.normals.size(), 6u);
    EXPECT_NEAR(std::abs(mesh.normals[1].z), 1, 0.06f) << "the ridge averages both faces";
    EXPECT_NEAR(std::abs(mesh.normals[0].z), std::sqrt(0.5f), 1e-6f);
}

TEST_F(PlyShape, SmoothReplacesTheFilesNormals) {
    std::string properties = "property float nx\nproperty float ny\nproperty float nz\n";
    const std::string path = write(header("ascii", 3, properties, 1) +
                                   "0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n3 0 1 2\n");
    EXPECT_EQ(make_mesh("plymesh", {text("filename", path)}).normals[0], Vec3(1, 0, 0));
    EXPECT_EQ(make_mesh("plymesh", {text("filename", path), flag("smooth", true)}).normals[0],
              Vec3(0, 0, 1));
}

TEST_F(PlyShape, PolygonsAreCutIntoFans) {
    const TriangleMesh mesh = make_mesh(
        "plymesh", {text("filename", write(header("ascii", 5, "", 1) +
                                           "0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 2 0\n5 0 1 2 3 4\n"))});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4));
}

TEST_F(PlyShape, ErrorsNameFileFaceAndVertex) {
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_THAT(
        error_of("plymesh", {text("filename", write(header("ascii", 3, "", 2) + triangle +
                                                    "3 0 1 2\n3 0 1 7\n"))}),
        testing::AllOf(HasSubstr("mesh.ply\""), HasSubstr("face 1 of "),
                       HasSubstr("names vertex 7, but there are 3 vertices, numbered from 0")));
    EXPECT_THAT(error_of("plymesh", {text("filename", write(header("ascii", 3, "", 1) +
                                                            "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"))}),
                HasSubstr("is not finite: (1, nan, 0)"));
    EXPECT_THAT(error_of("plymesh", {text("filename", write("this is no mesh"))}),
                HasSubstr("can't be read: "));
    EXPECT_THAT(error_of("plymesh", {}),
                HasSubstr("plymesh needs a file: \"string filename\" [\"...\"]"));
}

TEST_F(PlyShape, TruncatedFilesAreErrors) {
    EXPECT_NE(error_of("plymesh",
                       {text("filename", write(header("ascii", 3, "", 1) + "0 0 0\n1 0 0\n"))}),
              "");
    EXPECT_NE(
        error_of("plymesh", {text("filename", write(header("binary_little_endian", 300, "", 1) +
                                                    std::string(100, 'x')))}),
        "");
}

}  // namespace
}  // namespace lxs::test
