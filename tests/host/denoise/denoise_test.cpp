// Protects the denoiser: noise falls by as many pixels as are alike, what is there is kept, what
// one half alone has seen is cut, and with more passes nothing is done at all; any size, any input,
// and the same bits on any number of threads.
#include "lxs/denoise/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "run_on_threads.h"

namespace lxs::test::denoise_test {
namespace {

/// Two halves with Gaussian noise of a standard deviation that is known, around `truth(x, y)`.
template <class Truth>
NoisyImage noisy(std::uint32_t width, std::uint32_t height, float deviation, const Truth& truth) {
    std::mt19937 generator(7);
    std::normal_distribution<float> normal;
    NoisyImage image{.width = width, .height = height, .halves = {}, .guides = {}};
    for (HalfImage& half : image.halves) {
        half.passes = 10;
        for (std::uint32_t y = 0; y < height; ++y) {
            for (std::uint32_t x = 0; x < width; ++x) {
                half.mean.emplace_back(truth(x, y) + deviation * normal(generator));
                half.variance.emplace_back(deviation * deviation);
            }
        }
    }
    return image;
}

float flat(std::uint32_t, std::uint32_t) {
    return 1;
}

float step(std::uint32_t x, std::uint32_t) {
    return x < 24 ? 1.0f : 5.0f;
}

float checks(std::uint32_t x, std::uint32_t y) {
    return (x + y) % 2 == 0 ? 1.0f : 1.2f;
}

Rgb mean_of_halves(const NoisyImage& image, std::size_t i) {
    return (image.halves[0].mean[i] + image.halves[1].mean[i]) * 0.5f;
}

/// Mean squared error of green.
template <class Truth>
double error(const NoisyImage& image, const std::vector<Rgb>& values, const Truth& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto x = static_cast<std::uint32_t>(i % image.width);
        const auto y = static_cast<std::uint32_t>(i / image.width);
        sum += std::pow(values[i].y - truth(x, y), 2);
    }
    return sum / static_cast<double>(values.size());
}

TEST(Denoise, AnImageWithoutNoiseStaysAsItIs) {
    for (const auto& truth : {flat, step, checks}) {
        const NoisyImage image = noisy(48, 32, 0, truth);
        const std::vector<Rgb> result = denoise(image);
        for (std::size_t i = 0; i < result.size(); ++i)
            ASSERT_NEAR(result[i].y, image.halves[0].mean[i].y, 1e-5f) << i;
    }
}

TEST(Denoise, NoiseFallsByAsManyPixelsAsAreAlike) {
    const NoisyImage image = noisy(64, 64, 0.2f, flat);
    // 529 pixels are in reach, and most of them pass for the same: the noise of the halves' mean
    // would fall to 0.02 / 529.
    EXPECT_LT(error(image, denoise(image), flat), 0.02 / 50);
}

TEST(Denoise, AStepIsKept) {
    const NoisyImage image = noisy(48, 32, 0.2f, step);
    const std::vector<Rgb> result = denoise(image);
    EXPECT_LT(error(image, result, step), 0.02 / 20);
    for (std::size_t y = 0; y < 32; ++y) {
        EXPECT_NEAR(result[y * 48 + 23].y, 1, 0.15f);
        EXPECT_NEAR(result[y * 48 + 24].y, 5, 0.15f);
    }
}

TEST(Denoise, AGuideKeepsWhatNoiseHides) {
    NoisyImage image = noisy(48, 48, 0.5f, checks);
    const double without = error(image, denoise(image), checks);
    GuideChannel guide;
    guide.least = 1e-3f;
    for (std::uint32_t i = 0; i < 48 * 48; ++i)
        guide.value.push_back(checks(i % 48, i / 48));
    guide.variance.assign(guide.value.size(), 0.0f);
    image.guides.push_back(guide);
    // Squared, the checks are 0.01 off their mean.
    EXPECT_GT(without, 0.009);
    EXPECT_LT(error(image, denoise(image), checks), 0.004);
}

TEST(Denoise, ItsEffectVanishesAsNoiseDoes) {
    // Half as much contrast as noise at first; variance falls with the passes.
    double before = std::numeric_limits<double>::infinity();
    for (const float passes : {1.0f, 100.0f, 10000.0f}) {
        const NoisyImage image = noisy(48, 48, 0.4f / std::sqrt(passes), checks);
        const std::vector<Rgb> result = denoise(image);
        double most = 0;
        for (std::size_t i = 0; i < result.size(); ++i)
            most = std::max(most, std::abs(double{result[i].y} - mean_of_halves(image, i).y));
        EXPECT_LT(most, before / 3) << passes;
        before = most;
    }
    EXPECT_LT(before, 0.02);
}

TEST(Denoise, WhatOneHalfAloneHasSeenIsCutAndALampIsKept) {
    NoisyImage image = noisy(33, 33, 0.1f, flat);
    const std::size_t path = 16 * 33 + 8, lamp = 16 * 33 + 24;
    image.halves[0].mean[path] = Rgb(500.0f);
    image.halves[0].variance[path] = Rgb(500.0f * 500.0f);
    for (HalfImage& half : image.halves) {
        half.mean[lamp] = Rgb(500.0f);
        half.variance[lamp] = Rgb(4.0f);
    }
    const std::vector<Rgb> result = denoise(image);
    EXPECT_NEAR(result[path].y, 1, 0.2f);
    EXPECT_NEAR(result[lamp].y, 500, 5);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (i == lamp) continue;
        EXPECT_NEAR(result[i].y, 1, 0.3f) << i;
    }
}

TEST(Denoise, AnySizeAndInputGivesFiniteValues) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [width, height] :
         {std::pair{1u, 1u}, {1u, 7u}, {9u, 1u}, {3u, 2u}, {17u, 5u}}) {
        NoisyImage image = noisy(width, height, 0.3f, flat);
        image.halves[0].mean[0] = Rgb(kNotANumber, kInfinite, -kInfinite);
        image.halves[1].variance[0] = Rgb(kInfinite, kNotANumber, -1.0f);
        const std::size_t pixels = image.halves[0].mean.size();
        image.guides.push_back(
            {std::vector<float>(pixels, kNotANumber), std::vector<float>(pixels, kInfinite), 0});
        image.halves[1].mean[pixels - 1] = Rgb(std::numeric_limits<float>::max());
        const std::vector<Rgb> result = denoise(image);
        ASSERT_EQ(result.size(), pixels);
        for (const Rgb& value : result) {
            EXPECT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z))
                << width << " x " << height;
        }
    }
}

TEST(Denoise, BitsAreTheSameOnAnyNumberOfThreads) {
    const NoisyImage image = noisy(40, 30, 0.2f, step);
    const auto run = [&] { return denoise(image); };
    EXPECT_EQ(concurrency::run_on(1, run), concurrency::run_on(4, run));
}

}  // namespace
}  // namespace lxs::test::denoise_test
