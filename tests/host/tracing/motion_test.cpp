// Moving instances: where they are at each time, how much of an image they cover, what is known of
// them.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"
#include "lxs/sdk/offset_origin.h"
#include "random_directions.h"

namespace lxs::test::motion_test {
namespace {

/// A unit sphere that goes along x from -2 to 2 between the times 1 and 3.
SceneContents moving_sphere() {
    SceneContents contents = instanced({primitive(sphere(1, Matrix()))}, {translation(-2, 0, 0)});
    contents.instances[0].motion = {{1, translation(-2, 0, 0)}, {3, translation(2, 0, 0)}};
    return contents;
}

Ray ray_at(const Vec3& origin, const Vec3& direction, float time) {
    Ray r = ray(origin, direction);
    r.time = time;
    return r;
}

TEST(Motion, InstancesAreWhereTheirTimeSays) {
    const auto scene = trace(moving_sphere());
    EXPECT_TRUE(scene->facts().has_motion);
    EXPECT_FALSE(trace({primitive(sphere(1, Matrix()))})->facts().has_motion);
    for (const float time : {0.0f, 1.0f, 1.3f, 2.0f, 2.75f, 3.0f, 9.0f}) {
        const float x = std::min(2.0f, std::max(-2.0f, 2 * (time - 2)));
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray_at(Vec3(x, 0, 5), Vec3(0, 0, -1), time), result)) << time;
        EXPECT_LT((result.p - Vec3(x, 0, 1)).length(), 1e-5f) << time;
        EXPECT_LT((result.ng - Vec3(0, 0, 1)).length(), 1e-5f);
        EXPECT_FALSE(hit(*scene, ray_at(Vec3(x + 1.1f, 0, 5), Vec3(0, 0, -1), time), result));
    }
    const Bounds box = scene->bounds();
    EXPECT_NEAR(box.min.x, -3, 1e-4f);
    EXPECT_NEAR(box.max.x, 3, 1e-4f);
}

TEST(Motion, CoverageIsTheMeanOverTime) {
    // Over all times the point (x, 0) is covered while |x - center| < 1: half of the way's length 4
    // in the middle, less towards the ends.
    const auto scene = trace(moving_sphere());
    Random random(3);
    for (const float x : {0.0f, 0.7f, 1.5f, 2.5f}) {
        constexpr int kCount = 20000;
        int covered = 0;
        for (int i = 0; i < kCount; ++i) {
            covered += is_black(
                scene->transmittance(ray_at(Vec3(x, 0, 5), Vec3(0, 0, -1), uniform(random, 1, 3))));
        }
        const double from = std::max(-2.0, x - 1.0), to = std::min(2.0, x + 1.0);
        const double expected = (to - from) / 4;
        EXPECT_NEAR(covered / double(kCount), expected, 4 * 0.5 / std::sqrt(kCount)) << x;
    }
}

TEST(Motion, TurnsOnAnArcAndKeepsItsLength) {
    // A small sphere one unit from the axis, turned by 120 degrees in a unit of time.
    SceneContents contents = instanced({primitive(sphere(0.1f, translation(1, 0, 0)))}, {Matrix()});
    contents.instances[0].motion = {{0, Matrix()}, {1, rotation({0, 0, 1}, 2.0943951)}};
    const auto scene = trace(std::move(contents));
    for (const float time : {0.0f, 0.21f, 0.5f, 0.83f, 1.0f}) {
        const float angle = 2.0943951f * time;
        const Vec3 center(std::cos(angle), std::sin(angle), 0);
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray_at(center + Vec3(0, 0, 5), Vec3(0, 0, -1), time), result));
        EXPECT_LT((result.p - center - Vec3(0, 0, 0.1f)).length(), 2e-3f) << time;
    }
}

TEST(Motion, LeavingRaysDoNotMeetTheirStart) {
    SceneContents contents = moving_sphere();
    contents.instances[0].motion[1].matrix = rotation({1, 2, 3}, 1) * translation(2, 500, 0);
    const auto scene = trace(std::move(contents));
    Random random(4);
    int remeetings = 0, hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const float time = uniform(random, 1, 3);
        const float share = (time - 1) / 2;
        const Vec3 center(-2 + 4 * share, 500 * share, 0);
        const Vec3 side = random_direction(random);
        SurfaceHit first, second;
        if (!hit(*scene, ray_at(center + side * 3, -side, time), first)) continue;
        ++hits;
        const Vec3 aside = random_direction(random);
        const Vec3 tangent = (aside - first.ng * aside.dot(first.ng)).normalized();
        const Vec3 direction = (tangent + first.ng * 1e-3f).normalized();
        const Vec3 origin = offset_origin(first.p, first.p_error, first.ng, direction);
        remeetings += hit(*scene, ray_at(origin, direction, time), second);
    }
    EXPECT_GT(hits, 10000);
    EXPECT_EQ(remeetings, 0);
}

}  // namespace
}  // namespace lxs::test::motion_test
