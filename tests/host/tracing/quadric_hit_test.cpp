// Spheres and disks: where rays meet them, cut ones too, and their surface coordinates.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"

namespace lxs::test::quadric_hit_test {
namespace {

constexpr float kPi = 3.14159265f;

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-6f) {
    EXPECT_LT((a - b).length(), tolerance) << a << " and " << b;
}

TEST(SphereHit, PointNormalAndCoordinates) {
    const auto scene = trace({primitive(sphere(2, translation(1, 0, 0)))});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(1, 5, 0), Vec3(0, -1, 0)), result));
    expect_near(result.p, Vec3(1, 2, 0));
    expect_near(result.ng, Vec3(0, 1, 0));
    expect_near(result.ns, result.ng);
    EXPECT_NEAR(result.uv.x, 0.25f, 1e-6f);
    EXPECT_NEAR(result.uv.y, 0.5f, 1e-6f);
    expect_near(result.dpdu, Vec3(-4 * kPi, 0, 0), 1e-5f);
    ASSERT_TRUE(hit(*scene, ray(Vec3(1, 0, 0), Vec3(0, 0, 1)), result));
    expect_near(result.p, Vec3(1, 0, 2));
    EXPECT_NEAR(result.uv.y, 1, 1e-6f);
}

TEST(SphereHit, FrontIsOutsideUnlessReversedOrMirrored) {
    // reverse_orientation already holds the mirroring of the shape's transform: a mirrored sphere
    // with nothing else in force arrives here with it set, and its front stays outside.
    struct Case {
        double z_scale;
        bool reversed;
        float outward;
    };
    for (const Case c :
         {Case{1, false, 1}, Case{1, true, -1}, Case{-1, true, 1}, Case{-1, false, -1}}) {
        Primitive ball = primitive(sphere(1, scaling(1, 1, c.z_scale)));
        ball.reverse_orientation = c.reversed;
        SurfaceHit result;
        ASSERT_TRUE(hit(*trace({ball}), ray(Vec3(5, 0, 0), Vec3(-1, 0, 0)), result));
        expect_near(result.ng, Vec3(c.outward, 0, 0));
    }
}

TEST(SphereHit, MirroredInstanceKeepsItsOutside) {
    const auto scene = trace(instanced({primitive(sphere(1, Matrix()))}, {scaling(1, -2, 1)}));
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 5, 0), Vec3(0, -1, 0)), result));
    expect_near(result.p, Vec3(0, 2, 0));
    expect_near(result.ng, Vec3(0, 1, 0));
}

TEST(SphereHit, TinySphereFarAway) {
    // Half a millimetre at a kilometre: the textbook quadratic in single precision loses it.
    const auto scene = trace({primitive(sphere(5e-4f, translation(0, 0, 0)))});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(1000, 0, 0), Vec3(-1, 0, 0)), result));
    EXPECT_NEAR(result.p.length(), 5e-4f, 1e-10f);
}

TEST(SphereHit, EveryPointLiesOnTheSphere) {
    const auto scene = trace({primitive(sphere(3, Matrix()))});
    for (int i = 0; i < 1000; ++i) {
        const float x = -2.9999f + 0.006f * static_cast<float>(i);
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray(Vec3(x, 0.001f, 1e4f), Vec3(0, 0, -1)), result));
        EXPECT_NEAR(Imath::V3d(result.p).length(), 3, 3e-7);
    }
}

TEST(SphereHit, TransformedSphereIsAnEllipsoid) {
    const Matrix m = scaling(1, 2, 3) * rotation({0, 0, 1}, kPi / 2) * translation(0, 0, 1);
    const auto scene = trace({primitive(sphere(1, m))});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(-9, 0, 1), Vec3(1, 0, 0)), result));
    expect_near(result.p, Vec3(-2, 0, 1));
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 0, 9), Vec3(0, 0, -1)), result));
    expect_near(result.p, Vec3(0, 0, 4));
    const Bounds box = scene->bounds();
    expect_near(box.min, Vec3(-2, -1, -2), 1e-5f);
    expect_near(box.max, Vec3(2, 1, 4), 1e-5f);
}

TEST(SphereHit, CutSphereIsOpen) {
    const Quadric cap{Sphere{1, 0, 1, 180}, Matrix()};  // the upper half with y >= 0
    const auto scene = trace({primitive(cap)});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 0.5f, 5), Vec3(0, 0, -1)), result));
    EXPECT_GT(result.p.z, 0.8f);
    EXPECT_FALSE(hit(*scene, ray(Vec3(0, -0.5f, 5), Vec3(0, 0, -1)), result));
    // From below through the open side: the inside of the cap, with the outward normal.
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 0.5f, -5), Vec3(0, 0, 1)), result));
    EXPECT_GT(result.p.z, 0.8f);
    EXPECT_GT(result.ng.z, 0.8f);
    // v runs from z_min to z_max, u over phi_max.
    ASSERT_TRUE(hit(*scene, ray(Vec3(-5, 0.6f, 0.1f), Vec3(1, 0, 0)), result));
    EXPECT_NEAR(result.uv.x, std::atan2(result.p.y, result.p.x) / kPi, 1e-5f);
    EXPECT_NEAR(result.uv.y, std::asin(0.1f) / (kPi / 2), 1e-5f);
}

TEST(DiskHit, RingWithAHole) {
    const Quadric ring{Disk{0.5f, 2, 1, 360}, Matrix()};
    const auto scene = trace({primitive(ring)});
    SurfaceHit result;
    EXPECT_FALSE(hit(*scene, ray(Vec3(0.5f, 0, 5), Vec3(0, 0, -1)), result));
    EXPECT_FALSE(hit(*scene, ray(Vec3(2.5f, 0, 5), Vec3(0, 0, -1)), result));
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 1.25f, 5), Vec3(0, 0, -1)), result));
    expect_near(result.p, Vec3(0, 1.25f, 0.5f));
    expect_near(result.ng, Vec3(0, 0, 1));
    EXPECT_NEAR(result.uv.x, 0.25f, 1e-6f);
    EXPECT_NEAR(result.uv.y, 0.75f, 1e-6f);
    expect_near(result.dpdu, Vec3(-2 * kPi * 1.25f, 0, 0), 1e-5f);
}

}  // namespace
}  // namespace lxs::test::quadric_hit_test
