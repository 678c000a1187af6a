// Protects Veach's adjoint factor for shading normals: photons and shadow rays see the same
// brightness on a surface whose shading normal is tilted, and light that such a surface passes on
// by photons equals what eye paths find.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "eye/surface_normals.h"
#include "render_mock.h"

namespace aips::shading_normal_test {
namespace {

constexpr std::uint32_t kSize = 16;

mock::Scene tilted_floor(Vec3 tilt, bool hide_lambert) {
    mock::Scene scene;
    mock::Surface ground;
    ground.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    ground.normal_tilt = tilt;
    ground.material.hide_lambert = hide_lambert;
    scene.add(ground);
    mock::Surface lamp;
    lamp.shape = mock::Quad{{0.5f, -0.5f, 2}, {0, 1, 0}, {1, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {5, 5, 5};
    scene.add(lamp);
    scene.finish();
    return scene;
}

double mean_of(const mock::Scene& scene, const mock::Camera& camera, Settings settings) {
    settings.start_radius = 2;
    return mock::render(scene, camera, kSize, kSize, settings, 40).film.mean();
}

TEST(ShadingNormal, DirectLightByPhotonsEqualsShadowRays) {
    const mock::Camera down{{0, 0, 1}, {0, 0, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, kSize, kSize};
    for (const bool hide : {false, true}) {
        const mock::Scene scene = tilted_floor({0.5f, 0, 0}, hide);
        Settings settings = mock::small_settings(41, 60000);
        const double rays = mean_of(scene, down, settings);
        settings.direct_light_sampling = false;
        EXPECT_NEAR(mean_of(scene, down, settings) / rays, 1, 0.01);
    }
}

/// Floor with tilted normals lights a ceiling: L D(tilted) D E. The ceiling's brightness by photons
/// has a closed counterpart: the radiance of the floor integrated over the ceiling's view, which
/// the engine itself gives when the floor is seen instead of shining (shadow rays at the floor).
TEST(ShadingNormal, LightPassedOnMatchesRadianceSeen) {
    mock::Scene scene;
    mock::Surface floor;
    floor.shape = mock::Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    floor.normal_tilt = {0.6f, 0, 0};
    scene.add(floor);
    mock::Surface receiver;  // a small dark-sided patch that faces the floor
    receiver.shape = mock::Quad{{-0.2f, -0.2f, 0.5f}, {0, 0.4f, 0}, {0.4f, 0, 0}};
    receiver.material.reflectance = {0.8f, 0.8f, 0.8f};
    scene.add(receiver);
    scene.add_point_light({2, 0, 1.5f}, {4, 4, 4});
    scene.finish();

    // Irradiance at the patch from the floor as eyes see it: mean over a cosine-weighted
    // hemisphere.
    constexpr std::uint32_t kWide = 200;
    Settings settings = mock::small_settings(42, 1000);
    settings.max_photon_depth = 1;  // direct light only: shadow rays
    double seen = 0;
    const float half = 8;
    const mock::Camera down{{0, 0, 0.4999f}, {0, 0, -1}, {half, 0, 0}, {0, half, 0}, kWide, kWide};
    const auto image = mock::render(scene, down, kWide, kWide, settings, 4).film.image();
    for (std::uint32_t i = 0; i < kWide * kWide; ++i) {
        const std::uint32_t column = i % kWide, row = i / kWide;
        const double x = half * (2 * (double(column) + 0.5) / kWide - 1);
        const double y = half * (2 * (double(row) + 0.5) / kWide - 1);
        const double w = 1 / ((1 + x * x + y * y) * (1 + x * x + y * y));  // cosine * solid angle
        seen += w * luminance(image[i]);
    }
    // The image plane covers all but a sliver of the hemisphere, where nothing is lit.
    const double irradiance = seen * (2 * half / kWide) * (2 * half / kWide);
    const double expected = 0.8 / 3.14159265 * irradiance;

    const mock::Camera up{{0, 0, 0.1f}, {0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0}, kSize, kSize};
    constexpr int kSeeds = 12;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        Settings photons = mock::small_settings(43 + std::uint64_t(seed), 200000);
        photons.max_photon_depth = 2;
        photons.start_radius = 30;  // pixels of 1/200: nearly as wide as the patch
        photons.alpha = 1;
        const double shone =
            mock::render(scene, up, kSize, kSize, photons, 8).film.mean() / expected;
        sum += shone;
        squares += shone * shone;
    }
    const double mean = sum / kSeeds;
    const double error = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
    EXPECT_LT(error, 0.02) << "too uncertain to tell";
    // Significance 0.2 % (Student's t, 11 degrees); the middle of the patch stands for all of it,
    // which is lit differently by half a per cent.
    EXPECT_NEAR(mean, 1, 4 * error + 0.005);
}

/// One photon along a tilted surface must not outweigh all others. What the bound takes is what
/// normal_ratio says: of light that arrives evenly, (wi.ns)^2 / kMostNormalRatio.
TEST(ShadingNormal, PhotonsAlongTheSurfaceAreBounded) {
    struct {
        Vec3 geometric_normal{0, 0, 1}, shading_normal = normalize(Vec3{0.6f, 0, 0.8f});
    } point;
    const Vec3 along = normalize(Vec3{1, 0, 1e-6f});
    EXPECT_EQ(normal_ratio(point, along), kMostNormalRatio);
    EXPECT_EQ(normal_ratio(point, {1, 0, 0}), 0);
    EXPECT_EQ(normal_ratio(point, {0, 0, 1}), 0.8f);

    // By quadrature over directions in the plane of both normals, on both sides of the surface:
    // of the flux |wi.ng| the Bsdf sees |wi.ns|, less what is beyond the bound.
    double lost = 0;
    constexpr int kSteps = 2000000;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        const double sine = std::sqrt(1 - cosine * cosine);
        const Vec3 wi{float(sine), 0, float(cosine)};
        lost +=
            2 *
            (double(abs_dot(wi, point.shading_normal)) - cosine * double(normal_ratio(point, wi))) /
            kSteps;
    }
    EXPECT_NEAR(lost, 0.36 / double(kMostNormalRatio), 0.02 * 0.36 / double(kMostNormalRatio));
}

}  // namespace
}  // namespace aips::shading_normal_test
