// Protects the occupancy grid: never a false "no", and few "yes" far from all visible points.
#include "aips/core/photon_map/occupancy.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"

namespace aips::occupancy_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<Vec3> plane_of_points(std::size_t count, Vec3 corner, float side, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Eye);
    std::vector<Vec3> points(count);
    for (Vec3& p : points) {
        const Vec2 u = random.next2();
        p = corner + Vec3{u.x * side, u.y * side, 0};
    }
    return points;
}

TEST(Occupancy, NeverMissesAPointWithinTheRadius) {
    for (const float offset : {0.0f, -37.0f, 1e5f}) {
        for (const float radius : {0.01f, 0.3f, 20.0f}) {
            const auto points = plane_of_points(500, {offset, offset, offset}, 10, 1);
            OccupancyGrid grid;
            grid.build(points, radius);
            RandomStream random(2, 0, 0, RandomDomain::Photon);
            for (int i = 0; i < 20000; ++i) {
                const Vec3 point = points[random.next_uint() % points.size()];
                // Half of them just at the radius, where rounding decides.
                const float distance = radius * (i % 2 ? 1.0f : random.next());
                const Vec3 p = point + square_to_uniform_sphere(random.next2()) * distance;
                if (length_squared(p - point) > radius * radius) continue;
                ASSERT_TRUE(grid.near_visible_point(p));
            }
        }
    }
}

TEST(Occupancy, AxisAlignedNeighboursAtTheRadius) {
    OccupancyGrid grid;
    const std::vector<Vec3> points{{0, 0, 0}};
    grid.build(points, 0.5f);
    for (const Vec3 p :
         {Vec3{0.5f, 0, 0}, Vec3{-0.5f, 0, 0}, Vec3{0, 0.5f, 0}, Vec3{0, 0, -0.5f}}) {
        EXPECT_TRUE(grid.near_visible_point(p));
    }
}

TEST(Occupancy, SaysNoFarAwayNearlyAlways) {
    const auto points = plane_of_points(10000, {0, 0, 0}, 10, 3);
    OccupancyGrid grid;
    grid.build(points, 0.05f);
    RandomStream random(4, 0, 0, RandomDomain::Photon);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec2 u = random.next2();
        wrong += grid.near_visible_point({10 * u.x, 10 * u.y, 1 + random.next()}) ? 1 : 0;
    }
    EXPECT_LT(wrong, 20000 / 3);
}

/// Jobs at once, each on a thread of its own.
void threads_for(std::uint32_t count, const Job& job) {
    std::vector<std::jthread> threads;
    for (std::uint32_t i = 0; i < count; ++i)
        threads.emplace_back([&job, i] { job(i); });
}

TEST(Occupancy, ThreadsMarkWhatOneDoes) {
    // Many points share words of the table, where the last of two writers could undo the first's.
    const auto points = plane_of_points(20000, {0, 0, 0}, 1, 7);
    OccupancyGrid one, many;
    one.build(points, 0.003f);
    many.build(points, 0.003f, threads_for);
    RandomStream random(8, 0, 0, RandomDomain::Photon);
    int marked = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vec2 u = random.next2();
        const Vec3 p{u.x, u.y, 0.02f * (random.next() - 0.5f)};
        ASSERT_EQ(one.near_visible_point(p), many.near_visible_point(p));
        marked += one.near_visible_point(p) ? 1 : 0;
    }
    EXPECT_GT(marked, 10000);
    EXPECT_LT(marked, 190000);
}

TEST(Occupancy, EmptyNanAndHugeInputs) {
    OccupancyGrid grid;
    EXPECT_FALSE(grid.near_visible_point({0, 0, 0}));
    grid.build({}, 1);
    EXPECT_FALSE(grid.near_visible_point({0, 0, 0}));
    const std::vector<Vec3> points{{kNan, 0, 0}, {3e38f, -3e38f, 1}, {1, 2, 3}};
    for (const float radius :
         {1e-30f, 1.0f, 0.0f, kNan, -1.0f, std::numeric_limits<float>::infinity()}) {
        grid.build(points, radius);
        EXPECT_TRUE(grid.near_visible_point({1, 2, 3}));
        EXPECT_TRUE(grid.near_visible_point({3e38f, -3e38f, 1}));
        EXPECT_FALSE(grid.near_visible_point({kNan, 0, 0}));
    }
}

TEST(Occupancy, MemoryIsBounded) {
    OccupancyGrid grid;
    const auto points = plane_of_points(5000, {0, 0, 0}, 10, 5);
    grid.build(points, 0.1f);
    EXPECT_LE(grid.memory_bytes(), OccupancyGrid::memory_bound_bytes(5000));
    const std::size_t bytes = grid.memory_bytes();
    grid.build(std::span(points).first(10), 0.1f);
    EXPECT_EQ(grid.memory_bytes(), bytes);
}

}  // namespace
}  // namespace aips::occupancy_test
