// What a hit on a triangle says: position, normals, texture coordinates, tangent, sides.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"

namespace lxs::test::triangle_hit_test {
namespace {

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-6f) {
    EXPECT_LT((a - b).length(), tolerance) << a << " and " << b;
}

const Vec3 kDown(0, 0, -1);

TEST(TriangleHit, NormalFollowsVertexOrderNotTheRay) {
    const auto scene = trace({primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    expect_near(result.ng, Vec3(0, 0, 1));
    expect_near(result.p, Vec3(0.25f, 0.5f, 0));
    EXPECT_FLOAT_EQ(result.distance, 1);
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, -1), -kDown), result));
    expect_near(result.ng, Vec3(0, 0, 1));
}

TEST(TriangleHit, ReverseOrientationTurnsBothNormals) {
    TriangleMesh mesh = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.normals.assign(4, Vec3(0.6f, 0, 0.8f));
    Primitive reversed = primitive(mesh);
    reversed.reverse_orientation = true;
    const auto scene = trace({reversed});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    expect_near(result.ng, Vec3(0, 0, -1));
    expect_near(result.ns, Vec3(-0.6f, 0, -0.8f));
}

TEST(TriangleHit, InterpolatesNormalsAndCoordinates) {
    TriangleMesh mesh = triangle(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.normals = {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.uvs = {Vec2(0, 0), Vec2(2, 0), Vec2(0, 4)};
    const auto scene = trace({primitive(mesh)});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    expect_near(result.ns, Vec3(0.25f, 0.5f, 0.25f).normalized());
    EXPECT_NEAR(result.uv.x, 0.5f, 1e-6f);
    EXPECT_NEAR(result.uv.y, 2, 1e-6f);
    expect_near(result.dpdu, Vec3(0.5f, 0, 0));
}

TEST(TriangleHit, ShadingNormalFallsBackToTheGeometricOne) {
    TriangleMesh mesh = triangle(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.normals.assign(3, Vec3(0.0f));
    const auto scene = trace({primitive(mesh)});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    expect_near(result.ns, result.ng);
}

TEST(TriangleHit, WithoutCoordinatesThereIsNoTangent) {
    const auto scene = trace({primitive(triangle(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    EXPECT_EQ(result.dpdu, Vec3(0.0f));
    EXPECT_EQ(result.uv, Vec2(0.5f, 0.5f));
}

TEST(TriangleHit, CollapsedCoordinatesGiveNoTangentAndNoNaN) {
    TriangleMesh mesh = triangle(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.uvs.assign(3, Vec2(0.3f, 0.3f));
    const auto scene = trace({primitive(mesh)});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
    EXPECT_EQ(result.dpdu, Vec3(0.0f));
}

TEST(TriangleHit, TellsTriangleMaterialAndMedia) {
    Primitive first = primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    Primitive second = primitive(parallelogram(Vec3(5, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    second.material_index = 3;
    second.interior = std::make_shared<Medium>(Rgb(1.0f), 1.5f);
    second.exterior = std::make_shared<Medium>(Rgb(2.0f), 1.0f);
    const Medium *interior = second.interior.get(), *exterior = second.exterior.get();
    const auto scene = trace({first, second});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(5.2f, 0.8f, 1), kDown), result));
    EXPECT_EQ(result.primitive, 1u);
    EXPECT_EQ(result.material, 3u);
    EXPECT_EQ(scene->medium(result.interior), interior);
    EXPECT_EQ(scene->medium(result.exterior), exterior);
    EXPECT_NE(result.bsdf, nullptr);
    EXPECT_EQ(result.light, nullptr);
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.8f, 0.2f, 1), kDown), result));
    EXPECT_EQ(result.primitive, 0u);
    EXPECT_EQ(result.interior, EnteredMedia());
}

TEST(TriangleHit, InstancePutsEverythingInTheWorld) {
    TriangleMesh mesh = parallelogram(Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0));
    mesh.normals.assign(4, Vec3(0.6f, 0, 0.8f));
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    // x -> 3x, then z -> x: the plane z = 0 becomes x = 10, its normal +x.
    const Matrix m = scaling(3, 1, 1) * rotation({0, 1, 0}, std::acos(0.0)) * translation(10, 0, 0);
    const auto scene = trace(instanced({primitive(mesh)}, {translation(0, 50, 0), m}));
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(15, 0.5f, 1.5f), Vec3(-1, 0, 0)), result));
    expect_near(result.p, Vec3(10, 0.5f, 1.5f), 1e-5f);
    expect_near(result.ng, Vec3(1, 0, 0));
    expect_near(result.ns, Vec3(0.8f, 0, -0.6f / 3).normalized());
    expect_near(result.dpdu, Vec3(0, 0, -6), 1e-5f);
}

TEST(TriangleHit, MirroredInstanceKeepsItsOutside) {
    const TriangleMesh mesh = parallelogram(Vec3(-1, -1, 1), Vec3(2, 0, 0), Vec3(0, 2, 0));
    const auto scene = trace(instanced({primitive(mesh)}, {scaling(1, 1, -1)}));
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.2f, 0.1f, -5), Vec3(0, 0, 1)), result));
    expect_near(result.ng, Vec3(0, 0, -1));
}

TEST(TriangleHit, PositionIsWithinItsErrorBoundOfThePlane) {
    const Vec3 a(1003.1f, -20.7f, 3.3f), b(1010.9f, 45.1f, 7.7f), c(990.4f, 12.0f, 60.2f);
    const auto scene = trace({primitive(triangle(a, b, c))});
    const Imath::V3d normal =
        (Imath::V3d(b) - Imath::V3d(a)).cross(Imath::V3d(c) - Imath::V3d(a)).normalized();
    for (int i = 1; i < 100; ++i) {
        const float u = 0.009f * static_cast<float>(i), v = 0.99f - u;
        const Vec3 target = a * (1 - u - v * 0.5f) + b * u + c * (v * 0.5f);
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray(Vec3(0, 300, -700), target - Vec3(0, 300, -700)), result));
        const double off = std::abs(normal.dot(Imath::V3d(result.p) - Imath::V3d(a)));
        const double bound = std::abs(normal.x) * result.p_error.x +
                             std::abs(normal.y) * result.p_error.y +
                             std::abs(normal.z) * result.p_error.z;
        EXPECT_LE(off, bound);
    }
}

TEST(TriangleHit, RespectsTheEndOfTheSegment) {
    const auto scene = trace({primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))});
    Ray segment = ray(Vec3(0.25f, 0.5f, 1), kDown);
    SurfaceHit result;
    segment.t_max = 0.999f;
    EXPECT_FALSE(hit(*scene, segment, result));
    segment.t_max = 1.001f;
    EXPECT_TRUE(hit(*scene, segment, result));
}

TEST(TriangleHit, MediumOfTheRayAttenuates) {
    const auto scene =
        trace_within({primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))},
                     std::make_shared<Medium>(Rgb(1, 0.5f, 0), 1));
    Ray r = ray(Vec3(0.25f, 0.5f, 2), kDown);
    r.media = scene->camera_media();
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, r, result));
    EXPECT_NEAR(result.transmittance.x, std::exp(-2.0f), 1e-6f);
    EXPECT_NEAR(result.transmittance.y, std::exp(-1.0f), 1e-6f);
    EXPECT_EQ(result.transmittance.z, 1);
}

TEST(TriangleHit, InstancesOfAnOuterObjectHaveItsName) {
    const TriangleMesh mesh = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    SceneContents contents = instanced({primitive(mesh)}, {Matrix(), translation(2, 0, 0)});
    contents.outer_objects = {"tree"};
    contents.instances[1].outer = 0;
    const auto scene = trace(std::move(contents));
    SurfaceHit own, outer;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), own));
    ASSERT_TRUE(hit(*scene, ray(Vec3(2.25f, 0.5f, 1), kDown), outer));
    EXPECT_EQ(scene->object_names()[own.object], "object");
    EXPECT_EQ(scene->object_names()[outer.object], "tree");
}

TEST(TriangleHit, EmptySceneIsMissed) {
    const auto scene = trace(std::vector<Primitive>{});
    SurfaceHit result;
    EXPECT_FALSE(hit(*scene, ray(Vec3(0), kDown), result));
    EXPECT_EQ(scene->transmittance(ray(Vec3(0), kDown)), Rgb(1.0f));
    EXPECT_TRUE(scene->bounds().isEmpty());
}

TEST(TriangleHit, MeshWithoutTrianglesIsLeftOut) {
    TriangleMesh empty;
    empty.positions = {Vec3(0)};
    const auto scene =
        trace({primitive(empty), primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))});
    SurfaceHit result;
    EXPECT_TRUE(hit(*scene, ray(Vec3(0.25f, 0.5f, 1), kDown), result));
}

}  // namespace
}  // namespace lxs::test::triangle_hit_test
