// Protects: every point beside a segment is found, once; whatever the directions, coordinates and
// radii.
#include "aips/core/photon_map/segment_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"

namespace aips::segment_grid_test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

bool is_beside(const Segment& segment, Vec3 p, float radius) {
    const Vec3 from = p - segment.origin;
    const float t = dot(from, segment.direction);
    return t >= 0 && t < segment.length &&
           length_squared(from - segment.direction * t) <= radius * radius;
}

/// How often each point is met by a query, of those beside the segment; points met per point
/// beside.
double expect_found_once(const SegmentGrid& grid, std::span<const Vec3> points, float radius,
                         const Segment& segment) {
    std::vector<int> met(points.size(), 0);
    std::size_t all = 0, beside = 0;
    grid.for_each_run(segment, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t slot = first; slot < last; ++slot)
            ++met[grid.order()[slot]];
        all += last - first;
    });
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LE(met[i], 1) << i;
        if (!is_finite(points[i]) || !is_beside(segment, points[i], radius)) continue;
        ++beside;
        EXPECT_EQ(met[i], 1) << i;
    }
    return beside > 0 ? double(all) / double(beside) : 0;
}

std::vector<Vec3> points_in_box(std::size_t count, Vec3 centre, Vec3 half, RandomStream& random) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const auto along = [&](float h) { return (2 * random.next() - 1) * h; };
        points.push_back(centre + Vec3{along(half.x), along(half.y), along(half.z)});
    }
    return points;
}

TEST(SegmentGrid, FindsWhatIsBesideOnceInAllDirections) {
    RandomStream random(1, 0, 0, RandomDomain::BeamPhotons);
    SegmentGrid grid;
    const struct {
        Vec3 centre, half;
        float radius;
    } cases[] = {{{}, {1, 1, 1}, 0.2f},           {{5, -3, 2}, {1, 0.01f, 2}, 0.05f},
                 {{1e4f, 0, 0}, {1, 1, 1}, 0.1f}, {{}, {1e-4f, 1e-4f, 1e-4f}, 1e-5f},
                 {{}, {1, 0, 0}, 0.01f},          {{}, {1, 1, 1}, 10.0f}};
    for (const auto& c : cases) {
        std::vector<Vec3> points = points_in_box(3000, c.centre, c.half, random);
        points.push_back({kInf, 0, 0});
        grid.build(points, c.radius, 1, serial_for);
        EXPECT_EQ(grid.size(), points.size() - 1);
        for (int i = 0; i < 60; ++i) {
            Vec3 direction = square_to_uniform_sphere(random.next2());
            if (i % 6 == 0) direction = i % 12 == 0 ? Vec3{1, 0, 0} : Vec3{0, 0, -1};
            if (i % 6 == 1) direction = normalize(Vec3{1, i % 12 == 1 ? 1.0f : 1e-6f, 0});
            const Vec3 through = points[std::size_t(i)];
            const float length = c.half.x * (0.2f + 3 * random.next());
            const Segment segment{through - direction * (random.next() * length), direction,
                                  i % 10 == 9 ? kInf : length};
            expect_found_once(grid, points, c.radius, segment);
        }
    }
}

TEST(SegmentGrid, MeetsFewOthers) {
    RandomStream random(2, 0, 0, RandomDomain::BeamPhotons);
    const std::vector<Vec3> points = points_in_box(100000, {}, {1, 1, 1}, random);
    SegmentGrid grid;
    grid.build(points, 0.1f, 1, serial_for);
    double met = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 direction = square_to_uniform_sphere(random.next2());
        met += expect_found_once(grid, points, 0.1f, {direction * -0.8f, direction, 1.6f}) / 100;
    }
    EXPECT_LT(met, 3);
}

TEST(SegmentGrid, BadQueriesFindNothing) {
    SegmentGrid grid;
    const auto expect_none = [&](const Segment& segment) {
        grid.for_each_run(segment, [](std::uint32_t, std::uint32_t) { ADD_FAILURE(); });
    };
    expect_none({{}, {1, 0, 0}, 1});
    const std::vector<Vec3> points{{0.5f, 0, 0}};
    for (const float radius : {0.1f, 0.0f, std::numeric_limits<float>::quiet_NaN()}) {
        grid.build(points, radius, 1, serial_for);
        expect_none({{kInf, 0, 0}, {1, 0, 0}, 1});
        expect_none({{0, 5, 0}, {1, 0, 0}, 1});
    }
}

TEST(SegmentGrid, MemoryIsBounded) {
    RandomStream random(3, 0, 0, RandomDomain::BeamPhotons);
    SegmentGrid grid;
    for (const std::size_t count : {100u, 20000u, 5000u}) {
        const std::vector<Vec3> points = points_in_box(count, {}, {1, 1, 1}, random);
        for (const float radius : {0.5f, 1e-3f}) {
            grid.build(points, radius, 1, serial_for);
            EXPECT_LE(grid.memory_bytes(), SegmentGrid::memory_bound_bytes(20000));
        }
    }
}

}  // namespace
}  // namespace aips::segment_grid_test
