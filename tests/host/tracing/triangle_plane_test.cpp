// Protects: hits are the same bits with the table of triangles' planes and, in scenes that are too
// large for it, without.
#include "triangle_plane.h"

#include <gtest/gtest.h>

#include <random>

#include "fakes.h"
#include "surface_point.h"

namespace lxs::test::triangle_plane_test {
namespace {

TriangleMesh random_triangles(int count) {
    TriangleMesh mesh;
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1; };
    for (int i = 0; i < 3 * count; ++i) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(uniform(), uniform(), 1 + uniform() / 8);
    }
    return mesh;
}

TEST(TrianglePlane, HitsAreTheSameWithAndWithoutTheTable) {
    constexpr int kTriangles = 500;
    for (const bool reversed : {false, true}) {
        Primitive one = primitive(random_triangles(kTriangles));
        one.reverse_orientation = reversed;
        std::vector<Primitive> primitives{one};
        ObjectNames names;
        const MediaTable media{SceneContents()};
        const SurfaceGroup with = make_surface_group(primitives, "", names, media, true);
        const SurfaceGroup without = make_surface_group(primitives, "", names, media, false);
        EXPECT_EQ(with.surfaces[0].planes.size(), std::size_t{kTriangles});
        EXPECT_TRUE(without.surfaces[0].planes.empty());
        for (std::uint32_t i = 0; i < kTriangles; ++i) {
            RawHit raw;
            raw.distance = 1;
            raw.u = raw.v = 0.25;
            raw.primitive = i;
            SurfaceHit a, b;
            locate(with.surfaces[0], nullptr, ray(Vec3(0.0f), Vec3(0, 0, 1)), raw, a);
            locate(without.surfaces[0], nullptr, ray(Vec3(0.0f), Vec3(0, 0, 1)), raw, b);
            EXPECT_EQ(a.ng, b.ng);
            EXPECT_EQ(a.p, b.p);
            EXPECT_EQ(a.p_error, b.p_error);
        }
    }
}

}  // namespace
}  // namespace lxs::test::triangle_plane_test
