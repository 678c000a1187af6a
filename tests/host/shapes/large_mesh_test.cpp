// Protects: large meshes, which all threads work on, are the same bits for any number of them, and
// the first fault in the file's order is the one that is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "run_on_threads.h"
#include "shape_fixture.h"
#include "temporary_folder.h"

namespace lxs::test::large_mesh_test {
namespace {

using testing::HasSubstr;

/// A wavy grid as a PLY file; faces name vertices in a shuffled order, so that all threads' ranges
/// of vertices meet in each block of faces.
struct Grid {
    static constexpr std::uint32_t kSide = 200;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> corners;

    Grid() {
        constexpr std::uint32_t kCount = (kSide + 1) * (kSide + 1);
        const auto shuffled = [](std::uint32_t i) { return i * 7919 % kCount; };
        vertices.resize(kCount);
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const std::uint32_t column = i % (kSide + 1), row = i / (kSide + 1);
            const auto x = static_cast<float>(column), y = static_cast<float>(row);
            vertices[shuffled(i)] = Vec3(x, y, 3 * std::sin(0.1f * x) * std::cos(0.17f * y));
        }
        for (std::uint32_t j = 0; j < kSide; ++j) {
            for (std::uint32_t i = 0; i < kSide; ++i) {
                const std::uint32_t a = j * (kSide + 1) + i, b = a + kSide + 1;
                for (const std::uint32_t corner : {a, a + 1, b + 1, a, b + 1, b})
                    corners.push_back(shuffled(corner));
            }
        }
    }
    std::string header(const std::string& format) const {
        return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices.size()) +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
               std::to_string(corners.size() / 3) +
               "\nproperty list uchar uint vertex_indices\nend_header\n";
    }
    std::string binary() const {
        std::string text = header("binary_little_endian");
        text.append(reinterpret_cast<const char*>(vertices.data()), vertices.size() * sizeof(Vec3));
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            text.push_back(3);
            text.append(reinterpret_cast<const char*>(&corners[i]), 12);
        }
        return text;
    }
    std::string ascii() const {
        std::ostringstream text;
        text.precision(9);
        text << header("ascii");
        for (const Vec3& v : vertices)
            text << v.x << ' ' << v.y << ' ' << v.z << '\n';
        for (std::size_t i = 0; i < corners.size(); i += 3)
            text << "3 " << corners[i] << ' ' << corners[i + 1] << ' ' << corners[i + 2] << '\n';
        return text.str();
    }
};

class LargeMesh : public testing::Test {
  protected:
    TriangleMesh read(const std::string& content) const {
        const Matrix turned(0.8, 0.6, 0, 0, -0.6, 0.8, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1);
        return make_mesh("plymesh", {text("filename", write(content))}, turned);
    }
    std::string error(const std::string& content) const {
        return error_of("plymesh", {text("filename", write(content))});
    }
    Grid grid_;

  private:
    std::string write(const std::string& content) const {
        return folder_.write("mesh.ply", content);
    }
    files::TemporaryFolder folder_;
};

void expect_same(const TriangleMesh& a, const TriangleMesh& b) {
    EXPECT_TRUE(a.positions == b.positions);
    EXPECT_TRUE(a.normals == b.normals);
    EXPECT_TRUE(a.indices == b.indices);
}

TEST_F(LargeMesh, IsTheSameForAnyNumberOfThreads) {
    const std::string content = grid_.binary();
    const TriangleMesh one = concurrency::run_on(1, [&] { return read(content); });
    EXPECT_EQ(one.indices.size(), grid_.corners.size());
    EXPECT_EQ(one.normals.size(), grid_.vertices.size());
    for (const unsigned threads : {2u, 7u})
        expect_same(one, concurrency::run_on(threads, [&] { return read(content); }));
}

TEST_F(LargeMesh, IsTheSameAsText) {
    expect_same(read(grid_.ascii()), read(grid_.binary()));
}

TEST_F(LargeMesh, RowsOfDifferentLengthsAreReadInTurn) {
    std::string content = grid_.binary();
    // The last two triangles as one face of four corners.
    const std::size_t last = content.size() - 13, before = last - 13;
    const std::string tip = content.substr(last + 9, 4);
    content.erase(last);
    content[before] = 4;
    content += tip;
    const std::string faces = std::to_string(grid_.corners.size() / 3);
    content.replace(content.find(faces), faces.size(),
                    std::to_string(grid_.corners.size() / 3 - 1));
    expect_same(read(content), read(grid_.binary()));
}

TEST_F(LargeMesh, TheFirstFaultIsTold) {
    grid_.vertices[30000].y = grid_.vertices[11111].x = std::numeric_limits<float>::infinity();
    EXPECT_THAT(error(grid_.binary()), HasSubstr("vertex 11111 of"));
    grid_.corners[3 * 60000 + 1] = 4'000'000;
    grid_.corners[3 * 22222 + 2] = 5'000'000;
    EXPECT_THAT(error(grid_.binary()), HasSubstr("face 22222 names vertex 5"));
    std::string shorter = grid_.binary();
    shorter.resize(shorter.size() - 1);
    EXPECT_THAT(error(shorter), HasSubstr("face 22222 names vertex 5"));
}

}  // namespace
}  // namespace lxs::test::large_mesh_test
