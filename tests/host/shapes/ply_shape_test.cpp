// Meshes in PLY files: text and binary, with and without normals and coordinates, damaged ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include <cmath>
#include <cstring>
#include <iterator>

#include "shape_fixture.h"
#include "temporary_folder.h"

namespace lxs::test::ply_shape_test {
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

const std::string kNormalsAndCoordinates =
    "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n";

/// A triangle in the text format, packed by gzip.
constexpr std::array<unsigned char, 129> kPackedTriangle{
    31,  139, 8,   0,   0,   0,   0,   0,   2,   255, 93,  141, 225, 10,  195, 32,  12,  132, 255,
    231, 41,  238, 9,   134, 174, 15,  84,  130, 70,  26,  176, 42,  234, 70,  221, 211, 207, 245,
    71,  7,   229, 32,  119, 124, 9,   185, 18,  7,   133, 92,  119, 238, 224, 230, 84,  97,  31,
    134, 36,  202, 46,  169, 227, 45,  181, 203, 129, 133, 74,  205, 101, 230, 129, 16,  243, 188,
    60,  238, 96,  220, 193, 231, 250, 17,  216, 9,   236, 127, 31,  181, 117, 188, 220, 198, 21,
    122, 85,  172, 154, 188, 58,  105, 36,  201, 175, 155, 176, 151, 74,  6,   83,  100, 207, 105,
    48,  157, 22,  252, 252, 73,  95,  177, 116, 120, 249, 180, 0,   0,   0};

TEST_F(PlyShape, PackedByGzip) {
    const std::string packed(kPackedTriangle.begin(), kPackedTriangle.end());
    const TriangleMesh mesh = make_mesh("plymesh", {text("filename", write(packed))});
    EXPECT_THAT(mesh.positions, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    for (const std::size_t size : {packed.size() - 1, packed.size() / 2, std::size_t{11}}) {
        EXPECT_THAT(error_of("plymesh", {text("filename", write(packed.substr(0, size)))}),
                    HasSubstr("can't be read"));
    }
}

TEST_F(PlyShape, FacesByNormals) {
    // Against the normals, and without any.
    const std::string against =
        header("ascii", 3, "property float nx\nproperty float ny\nproperty float nz\n", 1) +
        "0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n3 0 1 2\n";
    const std::string path = write(against);
    const auto indices = [&](bool by_normals) {
        return make_mesh("plymesh", {text("filename", path), flag("facesbynormals", by_normals)})
            .indices;
    };
    EXPECT_THAT(indices(false), ElementsAre(0u, 1u, 2u));
    EXPECT_THAT(indices(true), ElementsAre(0u, 2u, 1u));
    write(header("ascii", 3, "", 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_TRUE(make_mesh("plymesh", {text("filename", path), flag("facesbynormals", true)})
                    .normals.empty());
    EXPECT_FALSE(make_mesh("plymesh", {text("filename", path)}).normals.empty());
}

TEST_F(PlyShape, Backs) {
    const std::string path = write(header("ascii", 3, "", 1) + "0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    const TriangleMesh mesh =
        make_mesh("plymesh", {text("filename", path), numbers("float", "backs", {0.01})});
    ASSERT_EQ(mesh.indices.size(), 6u);
    const Vec3 &a = mesh.positions[mesh.indices[3]], &b = mesh.positions[mesh.indices[4]],
               &c = mesh.positions[mesh.indices[5]];
    EXPECT_LT(((b - a) % (c - a)).z, 0) << "turned over";
    EXPECT_NEAR(a.z, -0.02, 1e-6) << "behind the front, by a share of the extent";
}

TEST_F(PlyShape, BinaryAsLuxBlendWritesIt) {
    std::string content = header("binary_little_endian", 4, kNormalsAndCoordinates, 1);
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

const std::string kRoof =  // two faces with a common ridge, no normals
    "-1 0 0\n0 0 1\n0 1 1\n-1 1 0\n1 0 0\n1 1 0\n4 0 1 2 3\n4 1 4 5 2\n";

TEST_F(PlyShape, WithoutNormalsItIsSmooth) {
    const TriangleMesh mesh =
        make_mesh("plymesh", {text("filename", write(header("ascii", 6, "", 2) + kRoof))});
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
        testing::AllOf(HasSubstr("mesh.ply\""), HasSubstr("face 1 "),
                       HasSubstr("names vertex 7, but there are 3 vertices, numbered from 0")));
    EXPECT_THAT(error_of("plymesh", {text("filename", write(header("ascii", 3, "", 1) +
                                                            "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"))}),
                HasSubstr("is not finite: (1, nan, 0)"));
    EXPECT_THAT(error_of("plymesh", {text("filename", write("this is no mesh"))}),
                HasSubstr("can't be read: "));
    EXPECT_THAT(error_of("plymesh", {}),
                HasSubstr("plymesh needs a file: \"string filename\" [\"...\"]"));
}

/// A square of two triangles whose middle vertex no face uses, with normals and coordinates.
std::string square_with(const std::string& middle, const std::string& corner) {
    return middle + "\n-1 -1 0 " + corner + "\n1 -1 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n" +
           "-1 1 0 0 0 1 0 1\n4 1 2 3 4\n";
}

TEST_F(PlyShape, ValuesThatAreNoNumbersAreReplaced) {
    const auto read = [&](const std::string& middle, const std::string& corner,
                          RecordedDiagnostics& diagnostics, std::vector<ParameterValue> more = {}) {
        more.push_back(text("filename", write(header("ascii", 5, kNormalsAndCoordinates, 1) +
                                              square_with(middle, corner))));
        return std::get<TriangleMesh>(make_shape("plymesh", more, diagnostics));
    };
    RecordedDiagnostics unused;
    unused.lenient = true;
    EXPECT_EQ(read("nan nan 0 0 0 0 0 0", "0 0 1 0 0", unused).indices.size(), 6u);
    EXPECT_THAT(unused.warnings, testing::IsEmpty());
    RecordedDiagnostics normals;
    normals.lenient = true;
    const TriangleMesh mesh = read("0 0 0 nan nan nan 0 0", "nan 0 1 0 nan", normals);
    EXPECT_EQ(mesh.indices.size(), 6u);
    EXPECT_EQ(mesh.normals.at(1), Vec3(0, 0, 1));
    EXPECT_EQ(mesh.uvs.at(1), Vec2(0, 0));
    ASSERT_EQ(normals.warnings.size(), 2u);
    EXPECT_THAT(normals.warnings[0],
                testing::AllOf(HasSubstr("normal 0 of "), HasSubstr("mesh.ply\" and 1 more are not "
                                                                    "finite; the mean of the ")));
    EXPECT_THAT(normals.warnings[1], HasSubstr("mesh.ply\" is not finite; 0 0 is used"));
    RecordedDiagnostics discarded;
    discarded.lenient = true;
    read("0 0 0 nan nan nan 0 0", "0 0 1 0 0", discarded, {flag("discardmeshnormals", true)});
    EXPECT_THAT(discarded.warnings, testing::IsEmpty());
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

/// `value` with its bytes in the other order.
template <class T>
void append_reversed(std::string& content, T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    content.append(std::make_reverse_iterator(bytes + sizeof(T)),
                   std::make_reverse_iterator(bytes));
}

TEST_F(PlyShape, BigEndianWithColoursAndWhatIsNotUsed) {
    std::string content =
        "ply\r\nformat binary_big_endian 1.0\ncomment made by hand\nelement vertex 3\n"
        "property double x\nproperty float y\nproperty short z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
        "property list uchar float weights\nelement edge 1\nproperty int a\nelement face 1\n"
        "property uchar flags\nproperty list uint ushort vertex_index\nend_header\n";
    for (const int i : {0, 1, 2}) {
        append_reversed(content, static_cast<double>(i));
        append_reversed(content, i == 2 ? 1.5f : 0.0f);
        append_reversed(content, static_cast<std::int16_t>(-i));
        content += std::string("\xff\x00\x33\x7f", 4);
        content.push_back(1);
        append_reversed(content, 0.5f);
    }
    append_reversed(content, std::int32_t{7});
    content.push_back(9);
    append_reversed(content, std::uint32_t{3});
    for (const std::uint16_t corner : {0, 1, 2})
        append_reversed(content, corner);
    const TriangleMesh mesh = make_mesh("plymesh", {text("filename", write(content))});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(mesh.positions.at(2), Vec3(2, 1.5f, -2));
    EXPECT_NEAR(mesh.colors.at(1).x, 1, 1e-6f);
    EXPECT_NEAR(mesh.colors.at(1).z, 0.2f, 1e-6f);
    EXPECT_NEAR(mesh.alphas.at(1), 127 / 255.0f, 1e-6f);
    EXPECT_TRUE(make_mesh("plymesh", {text("filename", write(content)), flag("usecolor", false)})
                    .colors.empty());
}

TEST_F(PlyShape, DamagedHeadersAreErrors) {
    for (const char* content :
         {"ply\nformat ascii 1.0\nelement vertex x\nend_header\n",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n0\n",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nelement vertex 1\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n0 0 0\n1e999 0 0\n0 1 0\n",
          "ply\nformat utf8 1.0\nend_header\n", "ply\nproperty float x\nend_header\n"}) {
        EXPECT_THAT(error_of("plymesh", {text("filename", write(content))}),
                    HasSubstr("can't be read: "))
            << content;
    }
}

TEST_F(PlyShape, StlTextAndBinary) {
    const std::string as_text =
        "solid vertex wedge\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1e0 0\nendloop\nendfacet\nendsolid\n";
    std::string binary(80, ' ');
    const std::uint32_t facets = 1;
    binary.append(reinterpret_cast<const char*>(&facets), 4);
    const float facet[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    binary.append(reinterpret_cast<const char*>(facet), sizeof facet);
    binary.append(2, '\0');
    std::string solid_binary = binary;
    solid_binary.replace(0, 5, "solid");
    for (const std::string& content : {as_text, binary, solid_binary}) {
        const TriangleMesh mesh = make_mesh("stlmesh", {text("filename", write(content))});
        EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
        EXPECT_EQ(mesh.positions.at(1), Vec3(1, 0, 0));
        EXPECT_TRUE(mesh.normals.empty()) << "facets are flat";
    }
    for (const std::string& content :
         {binary.substr(0, 100), std::string("solid x\nvertex 1 2\n"), std::string("nothing")}) {
        EXPECT_THAT(error_of("stlmesh", {text("filename", write(content))}),
                    HasSubstr("can't be read: "));
    }
}

}  // namespace
}  // namespace lxs::test::ply_shape_test
