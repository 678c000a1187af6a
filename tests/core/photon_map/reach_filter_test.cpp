// Protects the filter before range queries: it never says no where a point is within reach, and
// seldom says yes where none is.
#include "aips/core/photon_map/reach_filter.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "aips/core/sampling/random.h"

namespace aips::reach_filter_test {
namespace {

std::vector<Vec3> scattered(std::size_t count, Vec3 center, float spread, std::uint64_t seed) {
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    std::vector<Vec3> points(count);
    for (Vec3& point : points) {
        const Vec2 u = random.next2();
        point = center + Vec3{u.x - 0.5f, u.y - 0.5f, random.next() - 0.5f} * (2 * spread);
    }
    return points;
}

TEST(ReachFilter, NeverDeniesWhatIsWithinReach) {
    for (const float at : {0.0f, -1e6f, 3e7f}) {
        const Vec3 center{at, -at, at};
        const float radius = at == 0 ? 0.05f : 8.0f;
        const auto points = scattered(200, center, 20 * radius, 1);
        ReachFilter filter;
        filter.build(points, radius);
        for (const Vec3& q : scattered(20000, center, 22 * radius, 2)) {
            for (const Vec3& point : points) {
                if (length_squared(point - q) > radius * radius) continue;
                ASSERT_TRUE(filter.may_reach(q));
            }
        }
        for (const Vec3& point : points)
            EXPECT_TRUE(filter.may_reach(point));
    }
}

TEST(ReachFilter, SeldomPassesInVain) {
    ReachFilter filter;
    filter.build(scattered(500, {}, 1000, 1), 1);
    unsigned passed = 0;
    for (const Vec3& q : scattered(10000, {}, 1000, 2))
        passed += filter.may_reach(q);
    EXPECT_LT(passed, 2000u);
}

/// Jobs of one build at the same time, so that the thread sanitizer sees them, and from the last
/// on.
void on_two_threads(std::uint32_t count, const Job& job) {
    const auto half = [&](std::uint32_t which) {
        for (std::uint32_t i = count; i-- > 0;) {
            if (i % 2 == which) job(i);
        }
    };
    std::thread other(half, 1);
    half(0);
    other.join();
}

TEST(ReachFilter, IsTheSameOnSeveralThreads) {
    const auto points = scattered(5000, {}, 40, 1);
    ReachFilter serial, parallel;
    serial.build(points, 1);
    parallel.build(points, 1, on_two_threads);
    unsigned passed = 0;
    for (const Vec3& q : scattered(20000, {}, 100, 2)) {
        ASSERT_EQ(serial.may_reach(q), parallel.may_reach(q));
        passed += serial.may_reach(q);
    }
    EXPECT_GT(passed, 1000u);
    EXPECT_LT(passed, 19000u);
}

TEST(ReachFilter, PointsThatAreNotFiniteReachNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    ReachFilter filter;
    filter.build(std::vector<Vec3>{{nan, 0, 0}}, 1);
    EXPECT_FALSE(filter.may_reach({0, 0, 0}));
    filter.clear();
    EXPECT_TRUE(filter.may_reach({0, 0, 0}));
}

}  // namespace
}  // namespace aips::reach_filter_test
