// Protects the radiance that `path` gives where the answer is known on paper.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "path_render.h"

namespace lxs::test::path_closed_form_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// The inside of an emissive sphere around the camera: albedo 0.5, radiance 1.
std::string furnace() {
    return camera_above(0.3, 60) +
           "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\n"
           "AreaLightSource \"area\" \"color L\" [1 1 1] \"float power\" [0] "
           "\"float efficacy\" [0]\n"
           "ReverseOrientation\nShape \"sphere\" \"float radius\" [2]\nWorldEnd\n";
}

void expect_near_relative(const MeanRadiance& result, double expected, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(result.mean[c] / expected, 1.0, tolerance) << "channel " << c;
    }
}

// In a closed enclosure of albedo a, k bounces add a^k: the sum shows what maxdepth counts.
TEST(PathClosedForm, FurnaceSumsTheBouncesThatMaxdepthAllows) {
    for (const std::uint32_t depth : {0u, 1u, 2u, 5u, 16u}) {
        PathSettings settings;
        settings.max_depth = depth;
        const double expected = (1 - std::pow(0.5, depth + 1)) / 0.5;
        expect_near_relative(render_mean(furnace(), settings, 256), expected, 0.004);
    }
}

TEST(PathClosedForm, PointLightFallsWithSquareAndCosine) {
    const std::string scene =
        camera_above(4) +
        "LightSource \"point\" \"point from\" [3 0 4] \"color L\" [50 50 50]\n"
        "Material \"matte\" \"color Kd\" [0.6 0.6 0.6]\n" +
        square(0, 5) + "WorldEnd\n";
    // I / d^2 * cos * Kd / pi with d = 5 and cos = 4/5.
    expect_near_relative(render_mean(scene, {}, 16), 50.0 / 25 * 0.8 * 0.6 / kPi, 0.002);
}

TEST(PathClosedForm, UniformSkyOnAFloorGivesKd) {
    const std::string scene = camera_above(4) +
                              "LightSource \"infinite\" \"color L\" [2 2 2]\n"
                              "Material \"matte\" \"color Kd\" [0.7 0.7 0.7]\n" +
                              square(0, 50) + "WorldEnd\n";
    expect_near_relative(render_mean(scene, {}, 256), 2 * 0.7, 0.005);
}

// A square lamp of half side 1 at height 2 above the point: form factor of four quarter squares.
TEST(PathClosedForm, AreaLightGivesItsFormFactor) {
    const std::string scene =
        camera_above(1) +
        "AttributeBegin\nAreaLightSource \"area\" \"color L\" [9 9 9] \"float power\" [0] "
        "\"float efficacy\" [0]\n" +
        square(2, 1, true) + "AttributeEnd\nMaterial \"matte\" \"color Kd\" [0.5 0.5 0.5]\n" +
        square(0, 3) + "WorldEnd\n";
    const double a = 0.5;  // half side over height
    const double root = std::sqrt(1 + a * a);
    const double form_factor = 4 / (2 * kPi) * (2 * a / root * std::atan(a / root));
    PathSettings settings;
    settings.max_depth = 1;
    expect_near_relative(render_mean(scene, settings, 256), 9 * 0.5 * form_factor, 0.004);
}

// includeenvironment false hides the sky from camera rays, also behind null sheets, but still
// lights.
TEST(PathClosedForm, EnvironmentIsHiddenFromTheCameraAlone) {
    const std::string sky = "LightSource \"infinite\" \"color L\" [2 2 2]\n";
    PathSettings hidden;
    hidden.include_environment = false;
    const std::string empty = camera_above(4) + sky + square(9, 0.1) + "WorldEnd\n";
    const std::string through_null =
        camera_above(4) + sky + "Material \"null\"\n" + square(0, 50) + "WorldEnd\n";
    const std::string floor = camera_above(4) + sky +
                              "Material \"matte\" \"color Kd\" [.7 .7 .7]\n" + square(0, 50) +
                              "WorldEnd\n";
    for (const std::string& scene : {empty, through_null}) {
        expect_near_relative(render_mean(scene, {}, 16), 2, 1e-5);
        EXPECT_EQ(render_mean(scene, hidden, 16).mean, Rgb(0.0f));
    }
    expect_near_relative(render_mean(floor, hidden, 256), 1.4, 0.005);
}

// Lights that are hidden from the camera: mirrors show them, null sheets do not.
TEST(PathClosedForm, HiddenLightsAreSeenInMirrorsAlone) {
    const auto scene = [](bool down, const std::string& hidden) {
        return camera_above(4) + "LightSource \"infinite\" \"color L\" [2 2 2]" + hidden +
               "\nAttributeBegin\nAreaLightSource \"area\" \"color L\" [3 3 3] \"float power\" [0] "
               "\"float efficacy\" [0]" +
               hidden + "\nMaterial \"null\"\n" + square(2, 1, down) +
               "AttributeEnd\nMaterial \"mirror\" \"color Kr\" [0.5 0.5 0.5]\n" + square(0, 50) +
               "WorldEnd\n";
    };
    const std::string hidden = " \"bool hidden\" [\"true\"]";
    // The sky and a lamp in the mirror; a lamp that faces the camera.
    expect_near_relative(render_mean(scene(true, ""), {}, 16), 0.5 * (2 + 3), 1e-5);
    expect_near_relative(render_mean(scene(true, hidden), {}, 16), 0.5 * (2 + 3), 1e-5);
    expect_near_relative(render_mean(scene(false, ""), {}, 16), 0.5 * 2 + 3, 1e-5);
    expect_near_relative(render_mean(scene(false, hidden), {}, 16), 0.5 * 2, 1e-5);
    const std::string sky = camera_above(4) + "LightSource \"infinite\" \"color L\" [2 2 2]" +
                            hidden + "\n" + square(9, 0.1) + "WorldEnd\n";
    EXPECT_EQ(render_mean(sky, {}, 16).mean, Rgb(0.0f));
}

// A slab of absorbing medium between two null sheets, passed by camera and shadow rays.
TEST(PathClosedForm, ClearMediumAbsorbsByBeerLambert) {
    const std::string scene =
        camera_above(4) +
        "MakeNamedVolume \"ink\" \"clear\" \"color absorption\" [0.2 0.4 0.8]\n"
        "LightSource \"distant\" \"point from\" [0 0 1] \"point to\" [0 0 0] \"color L\" [3 3 3]\n"
        "AttributeBegin\nMaterial \"null\"\nInterior \"ink\"\n" +
        square(2, 50) + square(1, 50, true) +
        "AttributeEnd\nMaterial \"matte\" \"color Kd\" [0.5 0.5 0.5]\n" + square(0, 50) +
        "WorldEnd\n";
    const MeanRadiance result = render_mean(scene, {}, 32);
    const std::string bare = camera_above(4) +
                             "LightSource \"distant\" \"point from\" [0 0 1] \"point to\" [0 0 0] "
                             "\"color L\" [3 3 3]\nMaterial \"matte\" \"color Kd\" [.5 .5 .5]\n" +
                             square(0, 50) + "WorldEnd\n";
    const MeanRadiance without = render_mean(bare, {}, 32);
    const double absorption[] = {0.2, 0.4, 0.8};
    for (int c = 0; c < 3; ++c) {
        // Once down with the light, once up to the camera, one unit thick.
        EXPECT_NEAR(result.mean[c] / without.mean[c], std::exp(-2 * absorption[c]), 1e-3);
    }
}

}  // namespace
}  // namespace lxs::test::path_closed_form_test
