// Protects: range queries find exactly the points within the radius, and the occupancy grid never
// denies one, whatever the points' places, the scene's scale and its distance from the origin.
#include <gtest/gtest.h>

#include "aips/core/photon_map/occupancy.h"
#include "aips/core/photon_map/photon_grid.h"
#include "aips/core/photon_map/point_grid.h"
#include "point_clouds.h"
#include "stress_case.h"

namespace degenerate_grids_test {
namespace {

using namespace aips;
using namespace stress;

std::vector<Photon> photons_at(const std::vector<Vec3>& points) {
    std::vector<Photon> photons;
    for (const Vec3 p : points) {
        Photon photon;
        photon.position = p;
        photons.push_back(photon);
    }
    return photons;
}

std::size_t count_within(const std::vector<Vec3>& points, Vec3 p, float radius) {
    std::size_t count = 0;
    for (const Vec3 q : points)
        count += length_squared(q - p) <= radius * radius;
    return count;
}

TEST(StressGrids, FindAllOfEveryCloudAndNothingElse) {
    const auto all = clouds(sized(400, 3000));
    const int queries = sized(20, 200);
    std::size_t found_in_all = 0;
    for (const Placement& placement : placements()) {
        for (const Cloud& cloud : all) {
            SCOPED_TRACE(cloud.name + ", " + placement.name());
            const std::vector<Vec3> points = placement.place(cloud.points);
            const std::vector<Photon> photons = photons_at(points);
            for (const float share : {1e-4f, 0.05f, 3.0f}) {
                const float radius = share * placement.scale;
                PhotonGrid grid;
                PointGrid exact;
                OccupancyGrid occupancy;
                grid.build(photons, radius);
                exact.build(points, radius);
                occupancy.build(points, radius);
                ASSERT_EQ(grid.size(), points.size());
                for (int q = 0; q < queries; ++q) {
                    const Vec3 p = points[std::size_t(q) * points.size() / std::size_t(queries)] +
                                   Vec3{0, 0, q % 2 ? 0 : 0.7f * radius};
                    const std::size_t expected = count_within(points, p, radius);
                    std::size_t found = 0;
                    grid.for_each_in_radius(p, radius, [&](const GridPhoton&) { ++found; });
                    ASSERT_EQ(found, expected) << radius;
                    ASSERT_EQ(exact.any_within_radius(p), expected > 0);
                    ASSERT_TRUE(expected == 0 || occupancy.near_visible_point(p));
                    found_in_all += found;
                }
            }
        }
    }
    record("10 clouds in 15 placements, three radii, against brute force",
           std::to_string(found_in_all) + " points found, none wrongly or twice");
}

TEST(StressGrids, LeaveOutWhatHasNoPlace) {
    std::vector<Vec3> points = impossible_points();
    points.push_back({0.5f, 0.5f, 0.5f});
    for (const float radius :
         {0.1f, 0.0f, -1.0f, std::nanf(""), 1e-45f, std::numeric_limits<float>::infinity()}) {
        PhotonGrid grid;
        OccupancyGrid occupancy;
        grid.build(photons_at(points), radius);
        occupancy.build(points, radius);
        EXPECT_EQ(grid.size(), 1u);
        std::size_t found = 0;
        for (const Vec3 p : points)
            grid.for_each_in_radius(p, grid.radius(), [&](const GridPhoton&) { ++found; });
        EXPECT_EQ(found, 1u) << radius;
        EXPECT_TRUE(occupancy.near_visible_point(points.back()));
        EXPECT_FALSE(occupancy.near_visible_point(points.front()));
    }
    record("NaN and infinite places; radii 0, -1, NaN, 1e-45, infinite", "one of 7 points found");
}

TEST(StressGrids, AreTheSameAtEveryScale) {
    const Cloud box = clouds(2000).back();
    const auto visited = [&](float scale) {
        PhotonGrid grid;
        grid.build(photons_at(Placement{scale, 0}.place(box.points)), 0.1f * scale);
        std::vector<std::uint32_t> order;
        for (int q = 0; q < 100; ++q) {
            grid.for_each_in_radius(
                box.points[std::size_t(q)] * scale, 0.1f * scale,
                [&](const GridPhoton& photon) { order.push_back(photon.index); });
        }
        return order;
    };
    const auto plain = visited(1);
    for (const float scale : {0x1p-40f, 0x1p-20f, 0x1p20f, 0x1p40f})
        EXPECT_EQ(visited(scale), plain) << scale;
    record("2000 photons scaled by 2^-40 to 2^40",
           std::to_string(plain.size()) + " visits in the same order");
}

}  // namespace
}  // namespace degenerate_grids_test
