// Protects what a hit says of triangles so small that the kernel gives no barycentric weights:
// scenes in kilometres, or with a million triangles to the millimetre.
#include <gtest/gtest.h>

#include "fakes.h"

namespace lxs::test::tiny_triangle_test {
namespace {

/// A triangle with corners (0, 0), (edge, 0), (0, edge) that tells its weights by its coordinates.
Primitive labelled(float edge) {
    TriangleMesh mesh = triangle(Vec3(0), Vec3(edge, 0, 0), Vec3(0, edge, 0));
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    return primitive(mesh);
}

TEST(TinyTriangle, HitsKeepTheirPlace) {
    for (const float edge : {1.0f, 1e-6f, 1e-9f, 1e-12f}) {
        const auto scene = trace({labelled(edge)});
        SurfaceHit result;
        const Ray across = ray(Vec3(0.25f, 0.5f, 1) * edge, Vec3(0, 0, -1));
        ASSERT_TRUE(hit(*scene, across, result)) << edge;
        EXPECT_NEAR(result.uv.x, 0.25f, 1e-6f) << edge;
        EXPECT_NEAR(result.uv.y, 0.5f, 1e-6f) << edge;
        EXPECT_LT((result.p - Vec3(0.25f, 0.5f, 0) * edge).length(), 1e-6f * edge);
    }
}

TEST(TinyTriangle, HitsOnInstancesKeepTheirPlace) {
    Matrix grow;
    grow.setScale(Imath::V3d(1e9));
    const auto scene = trace(instanced({labelled(1e-10f)}, {grow}));
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.025f, 0.05f, 1), Vec3(0, 0, -1)), result));
    EXPECT_NEAR(result.uv.x, 0.25f, 1e-5f);
    EXPECT_NEAR(result.uv.y, 0.5f, 1e-5f);
    EXPECT_LT((result.p - Vec3(0.025f, 0.05f, 0)).length(), 1e-6f);
}

}  // namespace
}  // namespace lxs::test::tiny_triangle_test
