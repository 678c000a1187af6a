// Protects: the engine's sums over photons, eye paths and passes are true after 1e9 contributions,
// with the bounds that their comments state. A sum or a count in single precision breaks them in
// the short form already.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "contribution/pass_noise.h"
#include "contribution/pixel_importance.h"
#include "estimate/gather.h"
#include "estimate/group_sums.h"
#include "image_of_pixels.h"
#include "media/volume_gather.h"
#include "mock_scene.h"
#include "radii/curvature_map.h"
#include "stress_case.h"

namespace render_sums_test {
namespace {

using namespace aips;
using namespace stress;

constexpr Vec3 kUp{0, 0, 1};
/// No multiple of a power of two, as float.
constexpr float kTerm = 0.3f;

void record_error(std::string_view what, double terms, double error, double most) {
    std::ostringstream tried, figure;
    tried << what << ", " << terms << " terms";
    figure << "relative error " << error << " of at most " << most;
    record(tried.str(), figure.str());
    EXPECT_LE(error, most);
}

/// Photons of power 0.3, 0.6, 0.9, all at the origin of a floor.
std::vector<Photon> equal_photons(std::size_t count) {
    Photon photon;
    photon.direction = photon.normal = kUp;
    photon.power = {kTerm, 2 * kTerm, 3 * kTerm};
    return std::vector<Photon>(count, photon);
}

EyeImage point_on_floor() {
    EyeImage image = mock::image_of_pixels(1, 1, {});
    VisiblePoint& point = image.visible_points[0];
    point.geometric_normal = point.shading_normal = point.wo = kUp;
    point.kd = point.throughput = kWhite;
    return image;
}

/// A pass gathers whenever a million photons wait.
TEST(StressSums, PhotonsAtAVisiblePoint) {
    constexpr std::size_t kPhotons = 1 << 20;
    const int gathers = sized(4, 954);
    PhotonGrid grid;
    grid.build(equal_photons(kPhotons), 0.1f);
    const EyeImage image = point_on_floor();
    InvalidSampleFilter filter;
    PhotonFlux flux;
    flux.reset(1, 1);
    for (int g = 0; g < gathers; ++g)
        gather_photons(image, grid, 0.1f, filter, flux);
    const double terms = double(kPhotons) * gathers;
    const double square =
        double(luminance(equal_photons(1)[0].power)) * double(luminance(equal_photons(1)[0].power));
    const double error = std::max(std::abs(double(flux.flux[0].r) / (terms * double(kTerm)) - 1),
                                  std::abs(double(flux.squares[0]) / (terms * square) - 1));
    EXPECT_EQ(flux.accepted[0], std::uint32_t(terms));
    record_error("equal photons at one visible point in " + std::to_string(gathers) + " gathers",
                 terms, error, (gathers + 1) * 0x1p-24);
}

TEST(StressSums, PhotonsAlongABeam) {
    mock::Scene scene;
    mock::Surface floor;
    floor.shape = mock::Quad{{-1, -1, -1}, {2, 0, 0}, {0, 2, 0}};
    scene.add(floor);
    scene.fill({{0.1f, 0.1f, 0.1f}, {0.5f, 0.5f, 0.5f}, 0});
    scene.finish();
    EyeImage image = mock::image_of_pixels(1, 1, {});
    image.beams = {{{0, 0, 0}, kUp, 1, nullptr, kWhite, 0, {}}};
    image.beam_footprint_sum = 0.05;
    const auto radiance_of = [&](std::size_t photons) {
        VolumeGather gather(scene, {});
        gather.begin_pass(0, 0, {}, image);
        gather.waiting().assign(photons, {{0, 0, 0.5f}, kUp, {kTerm, kTerm, kTerm}, nullptr, 0});
        InvalidSampleFilter filter;
        gather.gather(image, filter);
        EXPECT_EQ(gather.gathered(), photons);
        std::vector<Rgb> radiance(1);
        gather.add_to(image, 1, filter, radiance, {});
        return double(radiance[0].r);
    };
    constexpr std::size_t kPhotons = 1'000'000;
    const double error = std::abs(radiance_of(kPhotons) / (double(kPhotons) * radiance_of(1)) - 1);
    record_error("equal photons along one beam", double(kPhotons), error, 4 * 0x1p-24);
}

TEST(StressSums, CountsOfPhotonsDoNotWrap) {
    PhotonGrid grid;
    grid.build(equal_photons(1000), 0.1f);
    InvalidSampleFilter filter;
    PhotonFlux flux;
    flux.reset(1, 1);
    flux.accepted[0] = 0xFFFFFFFFu - 500;
    gather_photons(point_on_floor(), grid, 0.1f, filter, flux);
    EXPECT_EQ(flux.accepted[0], 0xFFFFFFFFu);
    EXPECT_EQ(saturated_sum(0xFFFFFFFEu, 1), 0xFFFFFFFFu);
    EXPECT_EQ(saturated_sum(0xFFFFFFFFu, 0), 0xFFFFFFFFu);
    EXPECT_EQ(saturated_sum(5, std::uint64_t{1} << 40), 0xFFFFFFFFu);
    record("1000 photons at a point that has 2^32 - 501", "stays at 2^32 - 1");
}

/// A pixel of 0.3, then of 0.9, through many passes.
TEST(StressSums, LuminanceOfAPixel) {
    constexpr std::size_t kPaths = 1'000'000;
    const int passes = sized(24, 1000);
    EyeImage image = mock::image_of_pixels(1, 1, {});
    image.positions.resize(kPaths, image.positions[0]);
    image.radiance.resize(image.positions.size());
    PixelImportance importance(1, 1);
    std::vector<Rgb> radiance;
    for (int pass = 0; pass < passes; ++pass) {
        if (2 * pass % passes == 0) {
            const float value = pass == 0 ? kTerm : 3 * kTerm;
            radiance.assign(kPaths, {value, value, value});
        }
        importance.add_pass(mock::seen_pixels(image, radiance, 1, 1));
    }
    // 1 / (L^2 + eps^2), L being the mean.
    const double weight = double(importance.weight(0));
    const double mean = std::sqrt(1 / (weight * (1 + kDarkestShare * kDarkestShare)));
    const double terms = double(kPaths) * passes;
    const double expected = (double(luminance({kTerm, kTerm, kTerm})) +
                             double(luminance({3 * kTerm, 3 * kTerm, 3 * kTerm}))) /
                            2;
    record_error("eye paths of one pixel in " + std::to_string(passes) + " passes", terms,
                 std::abs(mean / expected - 1), terms * 0x1p-53 + 4 * 0x1p-24);
}

TEST(StressSums, EyePathsOfOnePass) {
    const std::size_t paths = sized<std::size_t>(1'000'000, 20'000'000);
    EyeImage image = mock::image_of_pixels(1, 1, {});
    image.visible_points.clear();
    image.positions.resize(paths, image.positions[0]);
    image.radiance.resize(image.positions.size());
    PassNoiseMeter meter(1, 1);
    const PixelImportance importance(1, 1);  // weighs 1 before its first pass
    const PhotonVariances none{std::vector<float>(paths), {}};
    PassNoise noise;
    for (const float value : {kTerm, kTerm * 1.01f}) {
        const std::vector<Rgb> photons(paths, {value, value, value});
        noise = meter.add_pass(mock::seen_pixels(image, photons, 1, 1), none, 1, importance);
    }
    const double difference = double(luminance({kTerm * 1.01f, kTerm * 1.01f, kTerm * 1.01f})) -
                              double(luminance({kTerm, kTerm, kTerm}));
    record_error("noise between two passes that differ by 1 %", double(paths),
                 std::abs(noise.all / (difference * difference / 2) - 1),
                 // The difference of sums is a hundredth of them, and its square counts.
                 2 * 100 * double(paths) * 0x1p-53 + 0x1p-24);
}

TEST(StressSums, ProbesOfAPixel) {
    const std::uint64_t terms = sized<std::uint64_t>(20'000'000, 1'000'000'000);
    CurvatureMap map(1, 1);
    ProbeEstimate estimate;
    estimate.second_moment = 0.3;
    estimate.laplacian = {{{-0.3, 0.7}, {0.1, 1e-3}, {1e-5, 1e5}}};
    for (std::uint64_t i = 0; i < terms; ++i)
        map.add(0, estimate);
    const ProbeEstimate mean = map.mean(0);
    double error = std::abs(mean.second_moment / 0.3 - 1);
    for (std::size_t s = 0; s < kProbeScales; ++s) {
        const LaplacianEstimate &found = mean.laplacian[s], &one = estimate.laplacian[s];
        error = std::max({error, std::abs(found.value / one.value - 1),
                          std::abs(found.error2 * double(terms) / one.error2 - 1)});
    }
    record_error("probes of one pixel", double(terms), error, 2 * double(terms) * 0x1p-53);
}

}  // namespace
}  // namespace render_sums_test
