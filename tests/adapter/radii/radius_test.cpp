// Protects the radius of the density estimate: a function of photon paths shot and of pixel
// footprints, of nothing that photons do.
#include <gtest/gtest.h>

#include "render_mock.h"

namespace aips::radius_test {
namespace {

TEST(Radius, ShrinksWithPhotonsShotAndNotWithPasses) {
    const mock::Scene scene = mock::lamp_box({}, {});
    Settings settings = mock::small_settings(91, 1000);
    settings.radius = RadiusKind::Schedule;
    settings.alpha = 0.7;
    settings.photons_per_pass = 8000;
    const auto coarse = mock::radii(scene, settings, 3);
    settings.photons_per_pass = 4000;
    const auto fine = mock::radii(scene, settings, 5);
    EXPECT_FLOAT_EQ(coarse[0], fine[0]);
    EXPECT_FLOAT_EQ(coarse[1], fine[2]);
    EXPECT_FLOAT_EQ(coarse[2], fine[4]);
    EXPECT_LT(coarse[2], coarse[0]);
}

/// Photons that the Bsdf rejects (a black wall takes none) must not shrink the radius.
TEST(Radius, RejectedPhotonsHaveNoInfluence) {
    mock::Material black;
    black.reflectance = {0, 0, 0};
    Settings settings = mock::small_settings(92, 4000);
    settings.radius = RadiusKind::Schedule;
    settings.alpha = 0.7;
    EXPECT_EQ(mock::radii(mock::lamp_box({}, {}), settings, 4),
              mock::radii(mock::lamp_box(black, black), settings, 4));
}

/// startradius is in pixel footprints: twice the resolution, half the radius.
TEST(Radius, FollowsPixelFootprints) {
    const mock::Scene scene = mock::lamp_box({}, {});
    Settings settings = mock::small_settings(93, 1000);
    settings.start_radius = 3;
    const mock::Sampler sampler(1);
    float radius[2]{};
    for (const int i : {0, 1}) {
        const std::uint32_t size = i ? 64 : 32;
        const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, size, size);
        mock::Film film(size, size);
        mock::Log log;
        Engine engine({scene, camera, sampler, film, log}, settings);
        radius[i] = engine.render_pass(0).radius;
    }
    EXPECT_NEAR(radius[0] / radius[1], 2, 0.05);
}

TEST(Radius, PhotonMapKeepsIt) {
    const mock::Scene scene = mock::lamp_box({}, {});
    Settings settings = mock::small_settings(94, 4000);
    settings.alpha = 0.7;
    settings.mode = Mode::PhotonMap;
    const auto r = mock::radii(scene, settings, 3);
    EXPECT_EQ(r[0], r[2]);
}

}  // namespace
}  // namespace aips::radius_test
