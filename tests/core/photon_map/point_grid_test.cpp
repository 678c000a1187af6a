// Protects the exact test whether a photon can contribute: against brute force.
#include "aips/core/photon_map/point_grid.h"

#include <gtest/gtest.h>

#include <limits>

#include "aips/core/sampling/random.h"

namespace aips::point_grid_test {
namespace {

Vec3 random_point(RandomStream& random, float scale) {
    const Vec2 xy = random.next2();
    return Vec3{xy.x - 0.5f, xy.y - 0.5f, random.next() - 0.5f} * scale;
}

TEST(PointGrid, AgreesWithBruteForce) {
    for (const float radius : {0.01f, 0.1f, 0.5f}) {
        RandomStream random(1, 0, std::uint64_t(1000 * radius), RandomDomain::Photon);
        std::vector<Vec3> points;
        points.reserve(300);
        for (int i = 0; i < 300; ++i)
            points.push_back(random_point(random, 2));
        PointGrid grid;
        grid.build(points, radius);
        for (int i = 0; i < 5000; ++i) {
            // Half of the queries close to a point, so that both answers are met.
            Vec3 p = random_point(random, 2.5f);
            if (i % 2) p = points[std::size_t(i) % 300] + random_point(random, 3 * radius);
            bool near = false;
            for (const Vec3& q : points)
                near = near || length_squared(q - p) <= radius * radius;
            ASSERT_EQ(grid.any_within_radius(p), near);
        }
    }
}

TEST(PointGrid, LeavesOutWhatIsNotFinite) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Vec3> points{{kNan, 0, 0}, {1, 1, 1}};
    PointGrid grid;
    EXPECT_FALSE(grid.any_within_radius({0, 0, 0}));
    grid.build(points, 0.5f);
    EXPECT_TRUE(grid.any_within_radius({1, 1, 1.25f}));
    EXPECT_FALSE(grid.any_within_radius({0, 0, 0}));
    EXPECT_FALSE(grid.any_within_radius({kNan, 1, 1}));
    grid.build({}, 0.5f);
    EXPECT_FALSE(grid.any_within_radius({1, 1, 1}));
}

TEST(PointGrid, StaysWithinItsMemoryBound) {
    PointGrid grid;
    for (const std::size_t count : {1000u, 10u, 1023u, 1024u}) {
        const std::vector<Vec3> points(count, Vec3{1, 2, 3});
        grid.build(points, 0.1f);
        EXPECT_LE(grid.memory_bytes(), PointGrid::memory_bound_bytes(1024));
    }
}

}  // namespace
}  // namespace aips::point_grid_test
