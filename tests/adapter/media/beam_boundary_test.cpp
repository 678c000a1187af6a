// Protects light in media where they end, and where walls separate: next to a wall the beam
// estimate loses nothing, and what is behind the wall adds nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "media/volume_gather.h"
#include "render_mock.h"

namespace aips::beam_boundary_test {
namespace {

constexpr int kPaths = 400;  // photon paths of a pass, each with one collision in the box
constexpr int kPasses = 400;
constexpr float kRadius = 0.2f;
constexpr float kWall = 0.5f;  // half the side of the box along x

struct Mean {
    double mean = 0, error = 0;
};

/// What a beam along y at distance `off` from a wall gathers of collisions that fill the box evenly
/// about it, over what it should: with `behind` times as dense a fog on the wall's other side.
Mean light_beside_a_wall(float off, double behind, const Settings& settings) {
    mock::Scene scene;
    scene.add_box({-kWall, -1, -kWall}, {kWall, 1, kWall}, {});
    scene.finish();
    scene.fill({{}, {0.01f, 0.01f, 0.01f}, 0});
    VolumeBeam beam;
    beam.origin = {kWall - off, -0.8f, 0};
    beam.direction = {0, 1, 0};
    beam.length = 1.6f;
    beam.medium = scene.media();
    beam.throughput = kWhite;
    EyeImage image;
    image.beams = {beam};
    image.positions = {{0.5f, 0.5f}};
    image.beam_footprint_sum = 1;
    VolumeGather gather(scene, settings);
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> unit(-1, 1), chance(0, 1);
    double sum = 0, squares = 0;
    InvalidSampleFilter filter;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        gather.begin_pass(pass, 0, {.paths = kPaths}, image);
        for (int i = 0; i < int(kPaths * (1 + behind)); ++i) {
            VolumePhoton photon;
            photon.position = {kWall * unit(generator), unit(generator), kWall * unit(generator)};
            if (i >= kPaths) photon.position.x += 2 * kWall;
            photon.direction = {1, 0, 0};
            photon.power = kWhite;
            photon.medium = scene.media();
            gather.waiting().push_back(photon);
        }
        gather.gather(image, filter);
        gather.end_pass(image);
        std::vector<Rgb> radiance(1);
        gather.add_to(image, kPaths, filter, radiance, {});
        // Collisions per area across the beam: those in its length over the box's section.
        const double expected = double(beam.length) / 2 / double(4 * kWall * kWall) / (4 * M_PI);
        const double value = double(radiance[0].g) / expected;
        sum += value / kPasses;
        squares += value * value / kPasses;
    }
    return {sum, std::sqrt((squares - sum * sum) / kPasses)};
}

Settings settings_of_beams() {
    Settings settings = mock::small_settings(1, kPaths);
    settings.mode = Mode::PhotonMap;
    settings.start_radius = kRadius / 6;
    return settings;
}

// Four standard errors, and 1 % for what the fog dims.
TEST(BeamBoundary, NothingIsLostBesideAWall) {
    for (const float off : {0.02f, 0.1f, 0.3f}) {
        const Mean light = light_beside_a_wall(off, 0, settings_of_beams());
        EXPECT_NEAR(light.mean, 1, 4 * light.error + 0.01) << off;
        EXPECT_LT(light.error, 0.02) << off;
    }
}

TEST(BeamBoundary, NothingComesThroughAWall) {
    for (const float off : {0.02f, 0.1f}) {
        const Mean light = light_beside_a_wall(off, 3, settings_of_beams());
        EXPECT_NEAR(light.mean, 1, 4 * light.error + 0.01) << off;
    }
}

// Without either of both photons count as the papers say: half is lost, or half the other room's.
TEST(BeamBoundary, IsLeftOutWithItsParts) {
    for (bool Settings::*const part : {&Settings::photon_occlusion, &Settings::correct_edges}) {
        Settings settings = settings_of_beams();
        settings.*part = false;
        EXPECT_LT(light_beside_a_wall(0.02f, 0, settings).mean, 0.65);
        EXPECT_GT(light_beside_a_wall(0.02f, 3, settings).mean, 1.5);
    }
}

}  // namespace
}  // namespace aips::beam_boundary_test
