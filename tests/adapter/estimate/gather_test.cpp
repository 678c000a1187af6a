// Protects the gather: each photon counts once, only on its own surface and its own side.
#include <gtest/gtest.h>

#include <limits>

#include "estimate/gather.h"
#include "render_mock.h"

namespace aips::gather_test {
namespace {

Photon photon_at(Vec3 position, Vec3 direction, Vec3 normal) {
    Photon photon;
    photon.position = position;
    photon.direction = normalize(direction);
    photon.normal = normal;
    photon.power = {1, 2, 3};
    return photon;
}

/// What one Lambertian point at the origin, facing +z, seen from above, receives.
PhotonFlux flux_at_origin(const std::vector<Photon>& photons, const GatherRadii& radii,
                          Rgb kd = kWhite) {
    EyeImage image;
    VisiblePoint point;
    point.geometric_normal = point.shading_normal = point.wo = {0, 0, 1};
    point.kd = kd;
    image.visible_points = {point};
    PhotonGrid grid;
    grid.build(photons, radii.largest);
    InvalidSampleFilter filter;
    PhotonFlux flux;
    flux.reset(1, 1);
    gather_photons(image, grid, radii, filter, flux);
    return flux;
}

Rgb gathered(const std::vector<Photon>& photons, float radius) {
    return flux_at_origin(photons, radius).flux[0];
}

TEST(Gather, CountsEachPhotonOnceWhateverTheHashDoes) {
    // Few photons make a tiny hash table: neighbouring cells share buckets.
    for (int n = 1; n < 9; ++n) {
        std::vector<Photon> photons;
        for (int i = 0; i < n; ++i) {
            const float x = 0.02f * float(i) - 0.05f;
            photons.push_back(photon_at({x, -x, 0}, {0, 0, 1}, {0, 0, 1}));
        }
        EXPECT_FLOAT_EQ(gathered(photons, 0.5f).r, float(n));
    }
}

TEST(Gather, LeavesOutOtherSidesAndSurfaces) {
    const Vec3 up{0, 0, 1};
    EXPECT_EQ(gathered({photon_at({}, {0, 0, 1}, up)}, 0.1f), (Rgb{1, 2, 3}));
    // The back of the same sheet.
    EXPECT_TRUE(is_black(gathered({photon_at({}, {0, 0, -1}, up)}, 0.1f)));
    // A wall that meets the floor at a right angle.
    EXPECT_TRUE(is_black(gathered({photon_at({}, {1, 0, 1}, {1, 0, 0})}, 0.1f)));
    // The other face of a slab thinner than the radius: lit from below, through no fault of ours.
    EXPECT_TRUE(is_black(gathered({photon_at({0, 0, -0.02f}, {0, 0, -1}, {0, 0, -1})}, 0.1f)));
    // A parallel surface further away than the slab around the tangent plane.
    EXPECT_TRUE(is_black(gathered({photon_at({0, 0, -0.08f}, {0, 0, 1}, up)}, 0.1f)));
    // Outside of the radius.
    EXPECT_TRUE(is_black(gathered({photon_at({0.11f, 0, 0}, {0, 0, 1}, up)}, 0.1f)));
}

/// Inside a thin bowl: light that grazes the outside of the rim beside the point stays outside, and
/// what grazes the inside there is not lost.
TEST(Gather, TellsSidesWhereThePhotonLanded) {
    const Vec3 tilted = normalize(Vec3{0.6f, 0, 0.8f});
    const Photon outside = photon_at({0.05f, 0, 0}, {-1, 0, 0.5f}, tilted);
    EXPECT_GT(outside.direction.z, 0);
    EXPECT_TRUE(is_black(gathered({outside}, 0.1f)));
    const Photon inside = photon_at({0.05f, 0, 0}, {1, 0, -0.5f}, tilted);
    EXPECT_EQ(gathered({inside}, 0.1f), (Rgb{1, 2, 3}));
    // The normal that a photon remembers may be of either side.
    const Photon flipped = photon_at({0.05f, 0, 0}, {1, 0, -0.5f}, -tilted);
    EXPECT_EQ(gathered({flipped}, 0.1f), (Rgb{1, 2, 3}));
}

/// Only photons that bring light count: a count of others would shrink the radii of mode=ppm.
TEST(Gather, CountsTheAcceptedPhotonsOfEachPoint) {
    const Vec3 up{0, 0, 1};
    const Photon good = photon_at({}, up, up);
    Photon invalid = good, dark = good;
    invalid.power.g = std::numeric_limits<float>::quiet_NaN();
    dark.power = {};
    const std::vector<Photon> photons{good,
                                      photon_at({}, {0, 0, -1}, up),
                                      photon_at({}, {1, 0, 1}, {1, 0, 0}),
                                      photon_at({0.11f, 0, 0}, up, up),
                                      invalid,
                                      dark,
                                      good};
    EXPECT_EQ(flux_at_origin(photons, 0.1f).accepted[0], 2u);
    EXPECT_EQ(flux_at_origin(photons, 0.1f).counts.photons, 2u);
    // A wall that absorbs what the photon carries.
    Photon green = good;
    green.power = {0, 1, 0};
    EXPECT_EQ(flux_at_origin({green}, 0.1f, {1, 0, 1}).accepted[0], 0u);
    EXPECT_EQ(flux_at_origin({green}, 0.1f, {0, 1, 0}).accepted[0], 1u);
}

/// A point takes what lies within its own radius, whatever the largest is that the grid serves.
TEST(Gather, RadiusPerPoint) {
    const Vec3 up{0, 0, 1};
    std::vector<Photon> photons;
    photons.reserve(20);
    for (int i = 0; i < 20; ++i)
        photons.push_back(photon_at({0.01f * float(i) + 0.005f, 0, 0}, up, up));
    const std::vector<float> own{0.1f};
    GatherRadii radii(0.2f);
    EXPECT_EQ(flux_at_origin(photons, radii).accepted[0], 20u);
    radii.per_point = own;
    EXPECT_EQ(flux_at_origin(photons, radii).accepted[0], 10u);
}

/// A thin wall between a lit and a dark room: nothing leaks through, whatever the radius.
TEST(Gather, ThinWallKeepsTheDarkRoomDark) {
    mock::Scene scene;
    mock::Surface wall;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    mock::Surface divider;  // two faces, 0.01 apart, far thinner than the radius
    divider.shape = mock::Quad{{-1, 0.005f, -1}, {2, 0, 0}, {0, 0, 2}};
    scene.add(divider);
    divider.shape = mock::Quad{{-1, -0.005f, -1}, {0, 0, 2}, {2, 0, 0}};
    scene.add(divider);
    mock::Surface lamp;
    lamp.shape = mock::Ball{{0, 0.6f, 0}, 0.1f, false};
    lamp.emitted = {10, 10, 10};
    lamp.material.reflectance = {0, 0, 0};
    scene.add(lamp);
    scene.finish();
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 0.5f, 24, 24);
    Settings settings = mock::small_settings(101, 20000);
    settings.start_radius = 6;
    settings.direct_light_sampling = false;
    EXPECT_EQ(mock::render(scene, camera, 24, 24, settings, 4).film.mean(), 0);
}

}  // namespace
}  // namespace aips::gather_test
