// Protects the density estimate where positions are rounded coarsely: photons and visible points
// stand on a lattice there, and discs narrower than it would count none or far too many. And what
// stands near the origin of a wide scene from being blurred by the rounding elsewhere.
#include "radii/radius_floor.h"

#include <gtest/gtest.h>

#include "aips/core/sampling/sampling.h"
#include "mock_scene.h"

namespace aips::radius_floor_test {
namespace {

/// A ground with the origin in its middle.
mock::Scene ground(float half) {
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}};
    scene.add(surface);
    scene.finish();
    return scene;
}

EyeImage points_at(const std::vector<Vec3>& positions) {
    EyeImage image;
    for (const Vec3 p : positions)
        image.visible_points.emplace_back().position = p;
    return image;
}

TEST(RadiusFloor, FollowsCoordinatesNotTheExtent) {
    const mock::Scene scene = ground(237000);
    const RadiusFloor floor(scene);
    std::vector<float> radii;
    raise_to_floor(points_at({{0, 0, 0}, {1, 2, 0}}), floor, 0.001f, radii);
    EXPECT_TRUE(radii.empty()) << "a millimetre does near the origin of 474 km";
    raise_to_floor(points_at({{1, 2, 0}, {0, -200000, 0}}), floor, 0.001f, radii);
    ASSERT_EQ(radii.size(), 2u);
    EXPECT_EQ(radii[0], 0.001f);
    EXPECT_GT(radii[1], 2 * (200000 - std::nextafter(200000.0f, 0.0f)));
    EXPECT_GT(floor.least(), 0);
}

/// Density of uniform points on the lattice of floats, counted in discs of the floor's radius about
/// lattice points: right within 15 %, where discs of half the radius are off by half.
TEST(RadiusFloor, CountsThePointsOfTheLatticeAbout) {
    const mock::Scene scene = ground(237000);
    const Vec3 middle{200000, 200000, 0};
    const double step = double(std::nextafter(200000.0f, 1e9f)) - 200000;
    const auto share = [&](double radius) {
        int inside = 0;
        for (int x = -8; x <= 8; ++x) {
            for (int y = -8; y <= 8; ++y)
                inside += (x * x + y * y) * step * step <= radius * radius ? 1 : 0;
        }
        return inside * step * step / (double(kPi) * radius * radius);
    };
    const double radius = double(RadiusFloor(scene).at(middle));
    EXPECT_NEAR(share(radius), 1, 0.15);
    EXPECT_GT(std::abs(share(radius / 4) - 1), 0.15);
}

}  // namespace
}  // namespace aips::radius_floor_test
