// Protects the estimate of what the radius does: half of the bias is what the whole disc brings
// less what the inner half of its area does, where light is even, quadratic, or ends at an edge.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "estimate/edge_correction.h"
#include "estimate/pixel_estimate.h"
#include "render_mock.h"

namespace aips::bias_test {
namespace {

constexpr float kRadius = 0.1f;
constexpr int kPaths = 200;  // photon paths of a pass, all of which land in the square

struct Moments {
    double mean = 0, error = 0;
};

/// One Lambertian point at the origin of the plane z = 0, seen from above, that sends all of its
/// light on.
EyeImage point_at_origin() {
    EyeImage image;
    VisiblePoint point;
    point.geometric_normal = point.shading_normal = point.wo = {0, 0, 1};
    point.throughput = kWhite;
    point.kd = Rgb{1, 1, 1} * float(std::numbers::pi);
    image.visible_points = {point};
    image.positions = {{0.5f, 0.5f}};
    return image;
}

/// Twice the difference of whole and half discs over many passes of photons with x and y uniform in
/// (-0.2, 0.2) and `power(x, y)` each: irradiance per path is power / 0.16.
template <class Power>
Moments bias_of(const Power& power, EdgeCorrection* edges = nullptr) {
    constexpr int kPasses = 4000;
    const EyeImage image = point_at_origin();
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> place(-0.2f, 0.2f);
    double sum = 0, squares = 0;
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<Photon> photons;
        for (int i = 0; i < kPaths; ++i) {
            Photon photon;
            photon.position = {place(generator), place(generator), 0};
            photon.direction = photon.normal = {0, 0, 1};
            photon.power = kWhite * float(power(photon.position.x, photon.position.y));
            photons.push_back(photon);
        }
        PhotonGrid grid;
        grid.build(photons, kRadius);
        InvalidSampleFilter filter;
        PhotonFlux flux;
        flux.wants_inner = true;
        flux.reset(1, 1);
        gather_photons(image, grid, kRadius, filter, flux);
        if (edges) edges->correct(std::uint64_t(pass), 0, image, kRadius, flux);
        DiscEstimates discs;
        estimate_discs(image, flux, kRadius, kPaths, discs);
        const double bias = 2 * double(discs.whole[0].g - discs.half[0].g);
        sum += bias;
        squares += bias * bias;
    }
    const double mean = sum / kPasses;
    return {mean, std::sqrt((squares / kPasses - mean * mean) / kPasses)};
}

constexpr double kPerArea = 1 / 0.16;

// Significance of each: 1e-4, 4 standard errors.
TEST(Bias, EvenLightHasNone) {
    const Moments bias = bias_of([](float, float) { return 1.0; });
    EXPECT_GT(bias.error, 0);
    EXPECT_NEAR(bias.mean, 0, 4 * bias.error);
}

TEST(Bias, LightThatGrowsEvenlyHasNone) {
    const Moments bias = bias_of([](float x, float) { return 1 + 4 * x; });
    EXPECT_NEAR(bias.mean, 0, 4 * bias.error);
}

TEST(Bias, OfLightWithAKnownLaplacian) {
    // 1 + 100 x^2 has the Laplacian 200, and r^2 / 8 of it is the bias.
    const Moments bias = bias_of([](float x, float) { return 1 + 100 * x * x; });
    const double expected = 200 * kPerArea * double(kRadius) * double(kRadius) / 8;
    EXPECT_NEAR(bias.mean, expected, 4 * bias.error);
    EXPECT_LT(4 * bias.error, 0.2 * expected);
}

TEST(Bias, NothingWhereNoPhotonLands) {
    const Moments bias = bias_of([](float, float) { return 0.0; });
    EXPECT_EQ(bias.mean, 0);
    EXPECT_EQ(bias.error, 0);
}

TEST(Bias, InnerHalvesAreOfTheirOwnSurfaceAtEdges) {
    // The plane ends at 0.085: the inner half, of radius 0.071, is all surface.
    mock::Scene scene;
    mock::Surface surface;
    surface.shape = mock::Quad{{-1, -1, 0}, {1.085f, 0, 0}, {0, 2, 0}};
    scene.add(surface);
    scene.finish();
    Settings settings;
    settings.radius = RadiusKind::Schedule;
    EdgeCorrection edges(scene, settings, 1, 1);
    const auto until_edge = [](float x, float) { return x < 0.085f ? 1.0 : 0.0; };
    const Moments corrected = bias_of(until_edge, &edges);
    EXPECT_NEAR(corrected.mean, 0, 4 * corrected.error);
    // Uncorrected, the whole disc lacks what lies beyond.
    const double d = 0.85;
    const double lacking = (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
    const Moments bias = bias_of(until_edge);
    EXPECT_NEAR(bias.mean, -2 * kPerArea * lacking, 4 * bias.error);
}

}  // namespace
}  // namespace aips::bias_test
