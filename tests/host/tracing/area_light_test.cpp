// Emissive surfaces: which light a hit names, and that only the front shines.
#include <gtest/gtest.h>

#include <set>

#include "fakes.h"

namespace lxs::test::area_light_test {
namespace {

Primitive lamp(const Rgb& radiance, std::uint32_t group = 0) {
    Primitive result = primitive(parallelogram(Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)));
    result.emission = emission(radiance);
    result.emission->group = group;
    return result;
}

const Ray kFromAbove = ray(Vec3(0.3f, 0.2f, 3), Vec3(0, 0, -1));
const Ray kFromBelow = ray(Vec3(0.3f, 0.2f, -3), Vec3(0, 0, 1));

TEST(AreaLights, OnlyTheFrontShines) {
    const auto scene = trace({lamp(Rgb(3))});
    ASSERT_EQ(scene->lights().size(), 1u);
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, kFromAbove, result));
    EXPECT_EQ(result.light, scene->lights()[0]);
    EXPECT_EQ(result.emitted, Rgb(3));
    EXPECT_NE(result.bsdf, nullptr);
    ASSERT_TRUE(hit(*scene, kFromBelow, result));
    EXPECT_EQ(result.light, scene->lights()[0]);
    EXPECT_EQ(result.emitted, Rgb(0.0f));
}

TEST(AreaLights, ReverseOrientationTurnsTheShiningSide) {
    Primitive reversed = lamp(Rgb(1.0f));
    reversed.reverse_orientation = true;
    const auto scene = trace({reversed});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, kFromAbove, result));
    EXPECT_EQ(result.emitted, Rgb(0.0f));
    ASSERT_TRUE(hit(*scene, kFromBelow, result));
    EXPECT_EQ(result.emitted, Rgb(1.0f));
}

TEST(AreaLights, EachInstanceOfALampIsALightOfItsOwn) {
    SceneContents contents = instanced(
        {primitive(parallelogram(Vec3(5, 5, 0), Vec3(1, 0, 0), Vec3(0, 1, 0))), lamp(Rgb(2.0f), 1)},
        {Matrix(), translation(10, 0, 0), scaling(1, 1, -1) * translation(20, 0, 0)});
    contents.primitives = {lamp(Rgb(7.0f))};
    std::get<TriangleMesh>(contents.primitives[0].geometry).positions = {
        Vec3(-1, -1, -9), Vec3(1, -1, -9), Vec3(1, 1, -9), Vec3(-1, 1, -9)};
    contents.light_groups = {"default", "lamps"};
    const auto scene = trace(std::move(contents));
    ASSERT_EQ(scene->lights().size(), 4u);
    std::set<const Light*> met;
    for (const float x : {0.3f, 10.3f}) {
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray(Vec3(x, 0.2f, 3), Vec3(0, 0, -1)), result));
        EXPECT_EQ(result.emitted, Rgb(2.0f));
        ASSERT_NE(result.light, nullptr);
        EXPECT_EQ(result.light->group(), 1u);
        met.insert(result.light);
    }
    SurfaceHit mirrored;
    ASSERT_TRUE(hit(*scene, ray(Vec3(20.3f, 0.2f, -3), Vec3(0, 0, 1)), mirrored));
    EXPECT_EQ(mirrored.emitted, Rgb(2.0f)) << "a mirrored lamp shines from its mirrored front";
    met.insert(mirrored.light);
    EXPECT_EQ(met.size(), 3u);
    SurfaceHit dark;
    ASSERT_TRUE(hit(*scene, ray(Vec3(5.5f, 5.5f, 3), Vec3(0, 0, -1)), dark));
    EXPECT_EQ(dark.light, nullptr);
}

TEST(AreaLights, PhotonsLeaveTheSideThatHitsSeeShining) {
    // The light and the tracer must agree on the front, mirrored instances and spheres included.
    Primitive ball = primitive(sphere(0.5f, scaling(1, 1, -1)));
    ball.reverse_orientation = true;  // as the reader sets it for a mirroring transform
    ball.emission = emission(Rgb(1.0f));
    const auto scene =
        trace(instanced({lamp(Rgb(1.0f)), ball},
                        {translation(0, 0, 2), scaling(-1, 2, 1) * translation(30, 0, 0)}));
    ASSERT_EQ(scene->lights().size(), 4u);
    for (const Light* light : scene->lights()) {
        for (int i = 0; i < 16; ++i) {
            EmissionSample sample;
            const float u = (static_cast<float>(i) + 0.5f) / 16;
            if (!light->sample_emission({u, 0.3f, 0.6f, 0.2f}, sample)) continue;
            const Vec3 outside = sample.ray.origin + sample.normal * 0.01f;
            SurfaceHit result;
            ASSERT_TRUE(hit(*scene, ray(outside, -sample.normal), result));
            EXPECT_EQ(result.light, light);
            EXPECT_FALSE(is_black(result.emitted));
            EXPECT_GT(result.ng.dot(sample.normal), 0.99f);
        }
    }
}

}  // namespace
}  // namespace lxs::test::area_light_test
