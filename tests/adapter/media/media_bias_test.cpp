// Protects the estimate of what the radius does to light in media: half of the bias is what the
// whole section of a beam brings less what the inner half of its area does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "media/volume_gather.h"
#include "render_mock.h"

namespace aips::media_bias_test {
namespace {

constexpr int kPaths = 200;       // photon paths of a pass, each with one collision
constexpr float kLength = 0.5f;   // of the beam
constexpr float kRadius = 0.15f;  // three times that of surfaces
constexpr float kHalf = 0.3f;     // photons come no further from the beam
constexpr double kScattering = 0.01;

struct Moments {
    double mean = 0, error = 0;
};

/// One beam along y through a fog so thin that it dims nothing and scatters a hundredth.
struct FoggyBeam {
    FoggyBeam() {
        scene.add_box({-1, -1, -1}, {1, 1, 1}, {});
        scene.finish();
        scene.fill({{}, kWhite * float(kScattering), 0});
        VolumeBeam beam;
        beam.direction = {0, 1, 0};
        beam.length = kLength;
        beam.medium = medium();
        beam.throughput = kWhite;
        image.beams = {beam};
        image.positions = {{0.5f, 0.5f}};
        image.beam_footprint_sum = 1;
        settings.mode = Mode::PhotonMap;
        settings.start_radius = kRadius / 6;
    }
    const void* medium() const { return scene.media(); }

    mock::Scene scene;
    EyeImage image;
    Settings settings = mock::small_settings(1, kPaths);
};

/// Twice the difference of whole and half sections over many passes of collisions with x and z
/// uniform in (-kHalf, kHalf) and `power(x, z)` each, and of whole sections themselves.
template <class Power>
std::pair<Moments, Moments> bias_and_light_of(const Power& power) {
    constexpr int kPasses = 4000;
    FoggyBeam fog;
    VolumeGather gather(fog.scene, fog.settings);
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> across(-kHalf, kHalf), along(0, kLength);
    double sums[2] = {}, squares[2] = {};
    for (int pass = 0; pass < kPasses; ++pass) {
        gather.begin_pass(std::uint64_t(pass), 0, {.paths = kPaths}, fog.image, {.inner = true});
        for (int i = 0; i < kPaths; ++i) {
            VolumePhoton photon;
            photon.position = {across(generator), along(generator), across(generator)};
            photon.direction = {1, 0, 0};
            photon.power =
                kWhite * float(kScattering * power(photon.position.x, photon.position.z));
            photon.medium = fog.medium();
            gather.waiting().push_back(photon);
        }
        InvalidSampleFilter filter;
        gather.gather(fog.image, filter);
        DiscEstimates discs;
        discs.whole.resize(1);
        discs.half.resize(1);
        gather.add_discs(fog.image, kPaths, discs);
        const double values[] = {2 * double(discs.whole[0].g - discs.half[0].g),
                                 double(discs.whole[0].g)};
        for (int k = 0; k < 2; ++k) {
            sums[k] += values[k] / kPasses;
            squares[k] += values[k] * values[k] / kPasses;
        }
    }
    EXPECT_NEAR(gather.radius(), kRadius, 1e-6f);
    const auto moments = [&](int k) {
        return Moments{sums[k], std::sqrt((squares[k] - sums[k] * sums[k]) / kPasses)};
    };
    return {moments(0), moments(1)};
}

/// Radiance for a power of one: density of collisions across the beam, times what scatters back.
constexpr double kPerPower = kScattering / (4 * std::numbers::pi) / (4.0 * 0.3 * 0.3);

// Significance of each: 1e-4, 4 standard errors; half a percent for what the fog dims.
TEST(MediaBias, EvenLightHasNone) {
    const auto [bias, light] = bias_and_light_of([](float, float) { return 1.0; });
    EXPECT_GT(bias.error, 0);
    EXPECT_NEAR(bias.mean, 0, 4 * bias.error);
    EXPECT_NEAR(light.mean, kPerPower, 4 * light.error + 0.005 * kPerPower);
}

TEST(MediaBias, OfLightWithAKnownLaplacian) {
    // 1 + 100 x^2 has the Laplacian 200 across the beam, and r^2 / 8 of it is the bias.
    const auto [bias, light] = bias_and_light_of([](float x, float) { return 1 + 100 * x * x; });
    const double expected = 200 * kPerPower * double(kRadius) * double(kRadius) / 8;
    EXPECT_NEAR(bias.mean, expected, 4 * bias.error + 0.005 * expected);
    EXPECT_LT(4 * bias.error, 0.2 * expected);
    // The light on the beam itself has a power of one; all that is more is the blur.
    EXPECT_NEAR(light.mean - bias.mean, kPerPower, 4 * (light.error + bias.error));
}

TEST(MediaBias, NothingThatIsNotAskedFor) {
    FoggyBeam fog;
    VolumeGather gather(fog.scene, fog.settings);
    gather.begin_pass(0, 0, {.paths = kPaths}, fog.image);
    DiscEstimates discs;
    discs.whole.resize(1);
    discs.half.resize(1);
    gather.add_discs(fog.image, kPaths, discs);
    EXPECT_EQ(discs.whole[0].g, 0);
    EXPECT_EQ(discs.half[0].g, 0);
}

}  // namespace
}  // namespace aips::media_bias_test
