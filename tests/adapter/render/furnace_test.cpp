// Protects the absolute scale of light: in a closed box with constant albedo and constant emission
// the radiance is the geometric sum over the scatterings allowed, everywhere. A lost, doubled or
// misweighted class of paths shifts it.
#include <gtest/gtest.h>

#include "render_mock.h"
#include "test_form.h"

namespace aips::furnace_test {
namespace {

/// Closed form: emission 1, albedo 0.5, up to `depth` scatterings.
double furnace_radiance(unsigned depth) {
    double sum = 0, term = 1;
    for (unsigned k = 0; k <= depth; ++k, term *= 0.5)
        sum += term;
    return sum;
}

mock::Scene furnace(const mock::Material& wall) {
    mock::Scene scene;
    mock::Surface surface;
    surface.material = wall;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    scene.finish();
    return scene;
}

/// Mean radiance in a view of the middle of one wall, further from all edges than the radius.
double measured(const mock::Scene& scene, Settings settings) {
    const std::uint32_t passes = statistics::sized(10u, 20u);
    constexpr std::uint32_t kSize = 32;
    settings.max_photon_depth = 8;
    settings.start_radius = 2;
    const auto camera = mock::camera_along_y({0, -0.5f, 0}, 0.4f, kSize, kSize);
    const auto r = mock::render(scene, camera, kSize, kSize, settings, passes);
    return r.film.mean();
}

TEST(Furnace, UnguidedPhotonsAndShadowRays) {
    const mock::Scene scene = furnace({});
    EXPECT_NEAR(measured(scene, mock::small_settings(1, 40000)), furnace_radiance(8),
                0.01 * furnace_radiance(8));
}

TEST(Furnace, PhotonsAlone) {
    const mock::Scene scene = furnace({});
    Settings settings = mock::small_settings(2, 40000);
    settings.direct_light_sampling = false;
    EXPECT_NEAR(measured(scene, settings), furnace_radiance(8), 0.01 * furnace_radiance(8));
}

TEST(Furnace, Guides) {
    const mock::Scene scene = furnace({});
    for (const GuideKind guide : {GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = mock::small_settings(3, 40000);
        settings.guide = guide;
        EXPECT_NEAR(measured(scene, settings), furnace_radiance(8), 0.01 * furnace_radiance(8))
            << mock::name(guide);
    }
}

TEST(Furnace, AdaptiveChains) {
    const mock::Scene scene = furnace({});
    for (const bool direct : {true, false}) {
        Settings settings = mock::small_settings(8, 40000);
        settings.photon_sampler = PhotonSampler::AdaptiveChains;
        settings.direct_light_sampling = direct;
        EXPECT_NEAR(measured(scene, settings), furnace_radiance(8), 0.01 * furnace_radiance(8));
    }
}

TEST(Furnace, FrozenEyePass) {
    const mock::Scene scene = furnace({});
    for (const Mode mode : {Mode::PhotonMap, Mode::Ppm}) {
        for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
            Settings settings = mock::small_settings(4, 40000);
            settings.mode = mode;
            settings.alpha = 0.7;
            settings.guide = guide;
            EXPECT_NEAR(measured(scene, settings), furnace_radiance(8), 0.01 * furnace_radiance(8));
        }
    }
}

/// The general gather (a Bsdf kept per visible point) agrees with the compact Lambertian one.
TEST(Furnace, GeneralBsdfInTheGather) {
    mock::Material wall;
    wall.hide_lambert = true;
    const mock::Scene scene = furnace(wall);
    EXPECT_NEAR(measured(scene, mock::small_settings(5, 40000)), furnace_radiance(8),
                0.01 * furnace_radiance(8));
}

/// Half of the albedo is a mirror: eye paths choose between storing and bouncing.
TEST(Furnace, DiffuseUnderMirror) {
    mock::Material wall;
    wall.kind = mock::Material::Kind::LambertAndMirror;
    wall.reflectance = {0.25f, 0.25f, 0.25f};
    wall.specular = {0.25f, 0.25f, 0.25f};
    const mock::Scene scene = furnace(wall);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        Settings settings = mock::small_settings(6, 40000);
        settings.guide = guide;
        settings.max_eye_depth = 32;
        settings.max_photon_depth = 32;
        constexpr std::uint32_t kSize = 32;
        settings.start_radius = 2;
        const auto camera = mock::camera_along_y({0, -0.5f, 0}, 0.4f, kSize, kSize);
        const auto r = mock::render(scene, camera, kSize, kSize, settings, 30);
        EXPECT_NEAR(r.film.mean(), 2.0, 0.02);
    }
}

/// The environment lights a convex matte ball to exactly albedo times its radiance, plus nothing.
TEST(Furnace, EnvironmentOnBall) {
    mock::Scene scene;
    mock::Surface ball;
    ball.shape = mock::Ball{{0, 2, 0}, 0.5f, false};
    scene.add(ball);
    scene.add_environment({1, 1, 1});
    scene.finish();
    constexpr std::uint32_t kSize = 16;
    const auto camera = mock::camera_along_y({0, 0, 0}, 0.1f, kSize, kSize);
    for (const bool direct : {true, false}) {
        Settings settings = mock::small_settings(7, 40000);
        settings.direct_light_sampling = direct;
        settings.start_radius = 3;
        const auto r = mock::render(scene, camera, kSize, kSize, settings, 40);
        EXPECT_NEAR(r.film.mean(), 0.5, 0.005) << "directlightsampling " << direct;
    }
}

}  // namespace
}  // namespace aips::furnace_test
