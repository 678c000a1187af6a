// Protects the radii of mode=ppm: they shrink as the paper's formula says, with accepted photons
// and with nothing else, and the mean over passes is the paper's estimate.
#include "radii/ppm_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "aips/core/sampling/random.h"
#include "estimate/pixel_estimate.h"
#include "render_mock.h"

namespace aips::ppm_radius_test {
namespace {

constexpr double kAlpha = 0.7;

/// White Lambertian points with a pixel footprint of radius 0.1 each.
EyeImage eye_image(std::size_t points, std::uint32_t groups = 1) {
    EyeImage image;
    image.groups = groups;
    image.positions.resize(points);
    image.radiance.assign(points * groups, Rgb{});
    image.footprint_sum = 0.1 * double(points);
    for (std::uint32_t i = 0; i < points; ++i) {
        VisiblePoint point;
        point.kd = point.throughput = kWhite;
        point.sample = i;
        image.visible_points.push_back(point);
    }
    return image;
}

PpmRadius policy() {
    Settings settings;
    settings.alpha = kAlpha;
    settings.start_radius = 3;
    return {settings, mock::lamp_box({}, {})};
}

PhotonFlux flux_of(const std::vector<std::uint32_t>& accepted) {
    PhotonFlux flux;
    flux.reset(accepted.size(), 1);
    flux.accepted = accepted;
    return flux;
}

TEST(PpmRadius, StartsAtTheSameRadiusEverywhere) {
    const EyeImage image = eye_image(3);
    PpmRadius ppm = policy();
    const GatherRadii radii = ppm.before_pass({}, image);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_FLOAT_EQ(radii.of(i), 3 * 2 * 0.1f);
    EXPECT_FLOAT_EQ(radii.mean, radii.largest);
}

/// R^2 = R0^2 times the product over passes of (N + alpha M) / (N + M), for each point on its own.
TEST(PpmRadius, ShrinksByTheFormula) {
    const EyeImage image = eye_image(3);
    PpmRadius ppm = policy();
    const float start = ppm.before_pass({}, image).of(0);
    ppm.after_pass(flux_of({10, 0, 1}));
    ppm.before_pass({}, image);
    ppm.after_pass(flux_of({5, 0, 0}));
    const GatherRadii radii = ppm.before_pass({}, image);
    EXPECT_FLOAT_EQ(radii.of(0), start * float(std::sqrt(0.7 * (7 + 0.7 * 5) / (7 + 5))));
    EXPECT_EQ(radii.of(1), start);  // met no photon
    EXPECT_FLOAT_EQ(radii.of(2), start * float(std::sqrt(0.7)));
    EXPECT_EQ(radii.largest, start);
    EXPECT_FLOAT_EQ(radii.mean, (radii.of(0) + radii.of(1) + radii.of(2)) / 3);
}

/// The paper's own bookkeeping (eq. 7-11) at one point with two light groups, in double.
struct PaperPoint {
    double radius, photons = 0, tau[2] = {0, 0};

    void pass(double new_photons, const double (&flux)[2]) {
        if (new_photons == 0) return;
        const double shrunk =
            radius * std::sqrt((photons + kAlpha * new_photons) / (photons + new_photons));
        for (const int g : {0, 1})
            tau[g] = (tau[g] + flux[g]) * shrunk * shrunk / (radius * radius);
        photons += kAlpha * new_photons;
        radius = shrunk;
    }
};

/// tau / (pi R^2 N), which PPM defines over the whole render, is the mean of the passes' estimates.
TEST(PpmRadius, MeanOverPassesIsThePapersEstimate) {
    constexpr std::uint64_t kPaths = 1000;
    constexpr int kPasses = 50;
    const EyeImage image = eye_image(1, 2);
    PpmRadius ppm = policy();
    InvalidSampleFilter filter;
    PaperPoint paper{double(ppm.before_pass({}, image).of(0))};
    RandomStream random(1, 0, 0, RandomDomain::Eye);
    double mean[2] = {0, 0};
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        PhotonFlux flux;
        flux.reset(1, 2);
        flux.accepted[0] = static_cast<std::uint32_t>(random.next() * 8);  // 0 at times
        for (const int g : {0, 1}) {
            const float value = flux.accepted[0] ? random.next() : 0.0f;
            flux.flux[std::size_t(g)] = {value, value, value};
        }
        std::vector<Rgb> radiance;
        estimate_pixels(image, flux, ppm.before_pass({}, image), kPaths, filter, radiance);
        ppm.after_pass(flux);
        for (const std::size_t g : {0u, 1u})
            mean[g] += double(radiance[g].g) / kPasses;
        paper.pass(flux.accepted[0], {double(flux.flux[0].g), double(flux.flux[1].g)});
    }
    const double pi = std::numbers::pi;
    const double area = pi * paper.radius * paper.radius;
    for (const int g : {0, 1}) {
        const double expected = paper.tau[g] / (pi * area * double(kPaths) * kPasses);
        EXPECT_NEAR(mean[g], expected, 1e-5 * expected);
    }
    EXPECT_LT(paper.radius, 0.5 * 0.6);  // it has shrunk at all
}

TEST(PpmRadius, MemoryIsFlatAndWithinItsBound) {
    const EyeImage image = eye_image(100);
    PpmRadius ppm = policy();
    for (std::uint64_t pass = 0; pass < 5; ++pass) {
        ppm.before_pass({}, image);
        ppm.after_pass(flux_of(std::vector<std::uint32_t>(100, 3)));
        EXPECT_EQ(ppm.memory_bytes(), PpmRadius::memory_bound_bytes(100));
    }
}

}  // namespace
}  // namespace aips::ppm_radius_test
