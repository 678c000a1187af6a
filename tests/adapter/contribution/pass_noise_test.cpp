// Protects what is known of a pass's noise: all of it, the photons' part whatever the eye's is, and
// both in images made of them.
#include "contribution/pass_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

#include "aips/core/sampling/random.h"
#include "estimate/group_sums.h"
#include "estimate/pixel_estimate.h"
#include "eye/light_choice.h"
#include "eye/traced_eye_image.h"
#include "image_of_pixels.h"
#include "photons/photon_pass.h"
#include "radii/radius_policy.h"
#include "render_mock.h"

namespace aips::pass_noise_test {
namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr double kLight = 3;
constexpr double kThickFogRadius = 0.2;

double sq(double x) {
    return x * x;
}

EyeImage eye_image() {
    return mock::image_of_pixels(kWidth, kHeight, {});
}

PhotonVariances variances(const EyeImage& image, const std::vector<Rgb>& photons,
                          const PhotonFlux& flux) {
    PhotonVariances result;
    photon_variances(image, photons, flux, result.surfaces);
    return result;
}

/// Number of photons, of mean `mean`: of many, each unlikely.
std::uint32_t poisson(double mean, RandomStream& random) {
    std::uint32_t count = 0;
    for (double product = double(random.next()); product > std::exp(-mean); ++count)
        product *= double(random.next());
    return count;
}

/// Mean noise over passes in which photons of power 1 / `per_pixel`, as many on average, bring
/// kLight times a factor of the eye path's, of relative variance `eye_variance`.
PassNoise measured(double eye_variance, const std::vector<double>& per_pixel) {
    EyeImage image = eye_image();
    PixelImportance importance(kWidth, kHeight);
    PassNoiseMeter meter(kWidth, kHeight);
    PassNoise mean;
    for (std::size_t pass = 0; pass < per_pixel.size(); ++pass) {
        PhotonFlux flux;
        flux.reset(image.positions.size(), 1);
        std::vector<Rgb> brought;
        const auto power = float(1 / per_pixel[pass]);
        for (std::size_t i = 0; i < image.positions.size(); ++i) {
            RandomStream random(17, pass, i, RandomDomain::Photon);
            const auto seen =
                float(kLight * (1 + std::sqrt(12 * eye_variance) * (double(random.next()) - 0.5)));
            const auto photons = float(poisson(per_pixel[pass], random));
            flux.flux[i] = kWhite * (photons * power);
            flux.squares[i] = photons * power * power;
            brought.push_back(kWhite * (photons * power * seen));
        }
        const auto paths = static_cast<std::uint64_t>(1000 * per_pixel[pass]);
        const PassNoise noise = meter.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight),
                                               variances(image, brought, flux), paths, importance);
        importance.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight));
        mean.all += noise.all / double(per_pixel.size() - 1);
        mean.photon_path += noise.photon_path / double(per_pixel.size() - 1);
        if (pass == 0) {
            EXPECT_EQ(noise.all, 0);
            EXPECT_EQ(noise.photon_path, 0);
        }
    }
    // It is relative to L^2 + eps^2, as pixels weigh, all of which are alike.
    mean.all *= 1 + sq(kDarkestShareOfSharing);
    mean.photon_path *= 1 + sq(kDarkestShareOfSharing);
    return mean;
}

// Photons of power 1 / m, m on average, have relative variance 1 / m, times 1 + the eye's. A
// photon path, of which 1000 bring one photon to a pixel, has 1000 times that of a photon.
TEST(PassNoise, FindsBothParts) {
    const std::vector<double> passes(9, 5.0);
    for (const double eye : {0.0, 0.1, 0.3}) {
        const PassNoise noise = measured(eye, passes);
        EXPECT_NEAR(noise.all - noise.photon_path / 5000, eye, 0.02) << eye;
        EXPECT_NEAR(noise.photon_path / (1000 * (1 + eye)), 1, 0.03) << eye;
    }
}

TEST(PassNoise, PassesMayDifferInTheirPhotons) {
    const PassNoise noise = measured(0.2, {4, 12, 4, 12, 4, 12, 4, 12, 4});
    EXPECT_NEAR(noise.all - noise.photon_path * (1.0 / 4000 + 1.0 / 12000) / 2, 0.2, 0.02);
    EXPECT_NEAR(noise.photon_path / (1000 * 1.2), 1, 0.03);
}

// What eye paths see without photons, of relative variance 0.3, is noise of the eye alone, though
// photons bring as much again.
TEST(PassNoise, WhatEyePathsSeeThemselvesIsTheEyes) {
    EyeImage image = eye_image();
    PixelImportance importance(kWidth, kHeight);
    PassNoiseMeter meter(kWidth, kHeight);
    PassNoise mean;
    PhotonFlux flux;
    flux.reset(image.positions.size(), 1);
    const std::vector<Rgb> brought(image.positions.size(), kWhite);
    constexpr int kPasses = 9;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (std::size_t i = 0; i < image.positions.size(); ++i) {
            RandomStream random(18, std::uint64_t(pass), i, RandomDomain::Eye);
            flux.flux[i] = kWhite;
            image.radiance[i] =
                kWhite * float(1 + std::sqrt(12 * 0.3) * (double(random.next()) - 0.5));
        }
        const PassNoise noise = meter.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight),
                                               variances(image, brought, flux), 1000, importance);
        importance.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight));
        mean.all += noise.all / (kPasses - 1);
        mean.photon_path += noise.photon_path / (kPasses - 1);
    }
    // Relative to the square of what both are together, 2, and eps.
    EXPECT_NEAR(mean.all * (1 + sq(kDarkestShareOfSharing)), 0.3 / 4, 0.005);
    EXPECT_EQ(mean.photon_path, 0);
}

/// What photons bring to the eye paths of one image in passes of their own, summed over these.
struct PhotonParts {
    double variance = 0, expected = 0;  ///< of the passes; as each pass tells
    double light = 0, of_surfaces = 0;  ///< luminance, and without media
    std::vector<double> by_pass;        ///< luminance
};

PhotonParts photon_parts(const mock::Scene& scene, const Settings& settings, std::uint64_t passes,
                         std::uint32_t thinning = 1) {
    constexpr std::uint32_t kSize = 16;
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 0.5f, kSize, kSize);
    const EyeImage image = mock::traced_eye_image(scene, camera, kSize, kSize * kSize, settings);
    const auto radius_policy = make_radius_policy(settings, scene, kSize, kSize);
    const DiscreteDistribution lights = light_choice(scene);
    PhotonPass photon_pass(scene, settings, lights, std::make_unique<PassGuide>(),
                           make_photon_source(false));
    InvalidSampleFilter filter(scene);
    PhotonFlux flux;
    std::vector<Rgb> radiance;
    PhotonVariances variances;
    std::vector<double> sums(image.positions.size()), squares(sums.size());
    PhotonParts parts;
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        PassPhotons photons;
        photons.before = pass * settings.photons_per_pass;
        photons.paths = settings.photons_per_pass;
        photons.counted = photons.paths;
        photons.thinning = thinning;
        const GatherRadii radii = radius_policy->before_pass(photons, image);
        photon_pass.shoot(pass, photons, 0, image, radii, filter, flux);
        estimate_pixels(image, flux, radii, photons.paths, filter, radiance);
        for (const Rgb& surface : radiance)
            parts.of_surfaces += double(luminance(surface));
        photon_pass.estimate(image, flux, radii, photons.paths, filter, radiance, &variances);
        const double before = parts.light;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const double light = double(luminance(radiance[i]));
            sums[i] += light;
            squares[i] += light * light;
            parts.light += light;
            parts.expected += double(variances.surfaces[i] + variances.beams[i]);
        }
        parts.by_pass.push_back(parts.light - before);
    }
    const auto n = double(passes);
    for (std::size_t i = 0; i < sums.size(); ++i)
        parts.variance += (squares[i] - sums[i] * sums[i] / n) * n / (n - 1);
    return parts;
}

// In fog before dim walls most of the light is the fog's, and its noise is that of its photons: the
// squares of what they bring foretell how passes differ.
TEST(PassNoise, PhotonsInFogTellTheirNoise) {
    mock::Material dim;
    dim.reflectance = {0.02f, 0.02f, 0.02f};
    mock::Scene scene = mock::lamp_box(dim, dim);
    scene.fill({{}, {0.5f, 0.5f, 0.5f}, 0});
    Settings settings = mock::small_settings(3, 4000);
    settings.direct_light_sampling = false;
    settings.start_radius = 3;
    settings.correct_edges = false;  // what walls near a beam add is not the photons'
    const PhotonParts parts = photon_parts(scene, settings, 60);
    EXPECT_LT(parts.of_surfaces, 0.3 * parts.light);
    EXPECT_NEAR(parts.expected / parts.variance, 1, 0.25);
}

// Where beams take one of eight photons, each counts eight times: the light is the same, and its
// noise is that of the photons that are left.
TEST(PassNoise, PhotonsThatBeamsLeaveOutTellTheirNoise) {
    mock::Material black;
    black.reflectance = {0, 0, 0};
    mock::Scene scene = mock::lamp_box(black, black);
    scene.fill({{1.5f, 1.5f, 1.5f}, {1.5f, 1.5f, 1.5f}, 0});
    Settings settings = mock::small_settings(4, 8000);
    settings.direct_light_sampling = false;
    settings.start_radius = kThickFogRadius;
    const PhotonParts all = photon_parts(scene, settings, 100);
    const PhotonParts some = photon_parts(scene, settings, 100, 8);
    for (const PhotonParts& parts : {all, some}) {
        EXPECT_EQ(parts.of_surfaces, 0);
        std::cout << "foretold over found: " << parts.expected / parts.variance << "\n";
        EXPECT_NEAR(parts.expected / parts.variance, 1, 0.15);
    }
    EXPECT_GT(some.variance, 3 * all.variance);
    // The same photons in both: what they differ by is chance of what was left out alone.
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < all.by_pass.size(); ++i) {
        const double difference = some.by_pass[i] - all.by_pass[i];
        sum += difference;
        squares += difference * difference;
    }
    EXPECT_LT(std::abs(sum), 3.3 * std::sqrt(squares));
    EXPECT_LT(std::sqrt(squares), 0.03 * all.light);
}

TEST(PassNoise, LightThatIsRefusedHasNoVariance) {
    float variance = 0;
    const float inf = std::numeric_limits<float>::infinity();
    add_variance(variance, 3, 2, 8);
    EXPECT_EQ(variance, 18);
    for (const float squares : {inf, 1e38f})
        add_variance(variance, 1e3, 1, squares);
    add_variance(variance, 0, double(inf), inf);
    add_variance(variance, 0, 0, 1);
    EXPECT_EQ(variance, 18);
}

TEST(PassNoise, BlackPassesHaveNone) {
    const EyeImage image = eye_image();
    PassNoiseMeter meter(kWidth, kHeight);
    PixelImportance importance(kWidth, kHeight);
    PhotonFlux flux;
    flux.reset(image.positions.size(), 1);
    for (int pass = 0; pass < 3; ++pass) {
        const PassNoise noise =
            meter.add_pass(mock::seen_pixels(image, image.radiance, kWidth, kHeight),
                           variances(image, image.radiance, flux), 1000, importance);
        EXPECT_EQ(noise.all, 0);
        EXPECT_EQ(noise.photon_path, 0);
        importance.add_pass(mock::seen_pixels(image, image.radiance, kWidth, kHeight));
    }
}

// A lamp in glass, seen by one path in 3072, is worth no more photons or eye paths than any pixel.
TEST(PassNoise, ASinglePixelCountsForLittle) {
    EyeImage image = eye_image();
    PassNoiseMeter meter(kWidth, kHeight);
    PixelImportance importance(kWidth, kHeight);
    PassNoise noise;
    for (int pass = 0; pass < 3; ++pass) {
        std::vector<Rgb> brought(image.positions.size(), kWhite);
        if (pass == 2) brought[100] = kWhite * 1e6f;
        noise = meter.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight), {}, 1000,
                               importance);
        if (pass < 2) importance.add_pass(mock::seen_pixels(image, brought, kWidth, kHeight));
    }
    EXPECT_NEAR(noise.all, kMostOfAPixel / (kWidth * kHeight), 1e-9);
}

TEST(PassNoise, MemoryIsBounded) {
    const EyeImage image = eye_image();
    const std::size_t paths = image.positions.size();
    PassNoiseMeter meter(kWidth, kHeight);
    const PixelImportance importance(kWidth, kHeight);
    EXPECT_GT(meter.memory_bytes(), 0u);
    for (int pass = 0; pass < 3; ++pass) {
        meter.add_pass(mock::seen_pixels(image, image.radiance, kWidth, kHeight),
                       PhotonVariances{std::vector<float>(paths), {}}, 1000, importance);
    }
    EXPECT_GE(meter.memory_bytes(), paths * sizeof(float));
    EXPECT_LE(meter.memory_bytes(), PassNoiseMeter::memory_bound_bytes(paths));
}

}  // namespace
}  // namespace aips::pass_noise_test
