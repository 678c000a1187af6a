// Protects light in scattering media: against closed forms, and next-event estimation there against
// scattered rays alone.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "path_render.h"

namespace lxs::path_media_test {
namespace {

using test::camera_above;
using test::MeanRadiance;
using test::render_mean;
using test::square;

constexpr const char* kMulti = "VolumeIntegrator \"multi\"\n";

PathSettings deep() {
    PathSettings settings;
    settings.max_depth = 10'000;
    return settings;
}

/// A cloud that absorbs nothing, under a sky of radiance 1: it can't be told from the sky.
TEST(PathMedia, WhiteCloudIsInvisibleUnderAnEvenSky) {
    const std::string scene =
        kMulti + camera_above(4, 30) +
        "MakeNamedVolume \"cloud\" \"homogeneous\" \"color sigma_s\" [0.5 1 3] \"color g\" [.5 0 "
        "-.3]\nLightSource \"infinite\" \"color L\" [1 1 1]\nMaterial \"null\"\nInterior "
        "\"cloud\"\n"
        "Shape \"sphere\" \"float radius\" [1.2]\nWorldEnd\n";
    for (const bool direct : {true, false}) {
        PathSettings settings = deep();
        settings.direct_light_sampling = direct;
        const MeanRadiance result = render_mean(scene, settings, 512);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(result.mean[c], 1, 4 * result.standard_error[c] + 1e-4) << direct;
        EXPECT_LT(max_component(result.standard_error), 0.02f);
    }
}

/// A slab lit from above and seen from above, scattered once: sigma_s p(-1) E (1 - e^(-2 sigma_t
/// d)) / (2 sigma_t).
TEST(PathMedia, SingleScatteringOfASlab) {
    const std::string light =
        "LightSource \"distant\" \"point from\" [0 0 1] \"point to\" [0 0 0] \"color L\" [3 3 3]\n";
    const std::string bare = camera_above(4) + light +
                             "Material \"matte\" \"color Kd\" [.5 .5 .5]\n" + square(0, 50) +
                             "WorldEnd\n";
    const double irradiance = render_mean(bare, {}, 16).mean.x * std::numbers::pi / 0.5;
    const std::string slab =
        kMulti + camera_above(4) + light +
        "MakeNamedVolume \"fog\" \"homogeneous\" \"color sigma_a\" [.1 .2 0] \"color sigma_s\" [.3 "
        ".6 1] \"color g\" [.4 .4 .4]\nAttributeBegin\nMaterial \"null\"\nInterior \"fog\"\n" +
        square(2, 50) + square(1, 50, true) +
        "AttributeEnd\nMaterial \"matte\" \"color Kd\" [0 0 0]\n" + square(0, 50) + "WorldEnd\n";
    PathSettings once;
    once.max_depth = 1;
    const MeanRadiance result = render_mean(slab, once, 2048);
    const double g = 0.4, backwards = (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g, 3));
    const double scattering[] = {0.3, 0.6, 1}, extinction[] = {0.4, 0.8, 1};
    for (int c = 0; c < 3; ++c) {
        const double expected = scattering[c] * backwards * irradiance *
                                (1 - std::exp(-2 * extinction[c])) / (2 * extinction[c]);
        EXPECT_NEAR(result.mean[c], expected, 4 * result.standard_error[c]) << c;
        EXPECT_LT(result.standard_error[c], 0.01 * expected);
    }
}

/// Fog all around, that begins and ends with the sphere around the scene: shadow rays to a sky and
/// rays that leave the scene agree on what remains of it.
TEST(PathMedia, EndlessFogUnderASky) {
    const std::string scene =
        kMulti + camera_above(4, 60) +
        "MakeNamedVolume \"fog\" \"homogeneous\" \"color sigma_a\" [.01 .02 .04] \"color sigma_s\" "
        "[.1 .05 .02] \"color g\" [.6 .6 .6]\nExterior \"fog\"\nLightSource \"infinite\" \"color "
        "L\" [1 1 1]\nMaterial \"matte\" \"color Kd\" [.5 .5 .5]\n" +
        square(0, 3) + "WorldEnd\n";
    PathSettings scattered = deep();
    scattered.direct_light_sampling = false;
    const MeanRadiance a = render_mean(scene, deep(), 1024);
    const MeanRadiance b = render_mean(scene, scattered, 1024, 2);
    EXPECT_LT(test::z_score(a, b), 4.5);
    EXPECT_LT(max_component(b.standard_error), 0.02f * a.mean.x);
    EXPECT_GT(a.mean.z, 0.1f);
}

}  // namespace
}  // namespace lxs::path_media_test
