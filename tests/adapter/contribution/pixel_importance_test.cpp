// Protects the weights of errors by pixel: 1 / (L^2 + eps) of the blurred image so far, of one
// scale in all passes, finite and positive whatever the image.
#include "contribution/pixel_importance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "aips/core/sampling/random.h"
#include "image_of_pixels.h"

namespace aips::pixel_importance_test {
namespace {

constexpr std::uint32_t kWidth = 40, kHeight = 30;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

EyeImage eye_image(std::uint32_t groups = 1) {
    return mock::image_of_pixels(kWidth, kHeight, {}, groups);
}

std::vector<Rgb> uniform(double value) {
    return std::vector<Rgb>(kPixels, kWhite * float(value));
}

/// Weights as they are before they are divided by their mean.
std::vector<double> weights_of(const PixelImportance& importance, const EyeImage& image) {
    std::vector<float> relative;
    const double mean = importance.weigh(image, relative);
    EXPECT_EQ(relative.size(), image.visible_points.size());
    EXPECT_TRUE(std::isfinite(mean) && mean > 0) << mean;
    std::vector<double> weights;
    for (const float w : relative) {
        EXPECT_TRUE(std::isfinite(w) && w > 0) << w;
        weights.push_back(mean * double(w));
    }
    return weights;
}

double mean_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double weight(double luminance, double mean) {
    return 1 / (luminance * luminance + kDarkestShare * kDarkestShare * mean * mean);
}

/// What the eye saw by itself says nothing of how bright photons will make it.
TEST(PixelImportance, LowBeforeTheFirstPass) {
    EyeImage image = eye_image(2);
    for (std::size_t i = 0; i < image.radiance.size(); ++i)
        image.radiance[i] = kWhite * (i % 4 == 0 ? 3.0f : 1.0f);
    for (const double w : weights_of(PixelImportance(kWidth, kHeight), image))
        EXPECT_EQ(w, double(kUnknownWeight));
}

/// A guide adds up what it learns in all passes: scores must not depend on the scene's units, nor
/// on how much of its light has been found.
TEST(PixelImportance, MeanWeightIsOneInAnyUnits) {
    const EyeImage image = eye_image();
    std::vector<std::vector<float>> found;
    for (const double unit : {1.0, 0x1p-20, 0x1p20}) {
        PixelImportance importance(kWidth, kHeight);
        for (int pass = 0; pass < 3; ++pass) {
            auto radiance = uniform(0);
            for (std::size_t i = 0; i < radiance.size(); ++i)
                radiance[i] = kWhite * float(unit * double((i * 7919 + std::size_t(pass)) % 31));
            importance.add_pass(mock::seen_pixels(image, radiance, kWidth, kHeight));
            std::vector<float> weights;
            importance.weigh(image, weights);
            EXPECT_NEAR(mean_of(weights), 1, 1e-5) << unit << " pass " << pass;
            if (pass == 2) found.push_back(weights);
        }
    }
    EXPECT_EQ(found[1], found[0]);
    EXPECT_EQ(found[2], found[0]);
}

/// Windows end at the image's border: pixels beyond are no black ones.
TEST(PixelImportance, BorderPixelsWeighAsOthersInAnEvenImage) {
    const EyeImage image = eye_image();
    PixelImportance importance(kWidth, kHeight);
    for (int pass = 0; pass < 3; ++pass) {
        importance.add_pass(mock::seen_pixels(image, uniform(2), kWidth, kHeight));
        for (const double w : weights_of(importance, image))
            EXPECT_NEAR(w, weight(2, 2), 1e-5);
    }
}

/// Mean over all eye paths within `radius` pixels along either axis.
double box_mean(const std::vector<double>& sums, const std::vector<double>& counts, int x, int y,
                int radius) {
    double sum = 0, count = 0;
    for (int v = std::max(0, y - radius); v <= std::min(int(kHeight) - 1, y + radius); ++v) {
        for (int u = std::max(0, x - radius); u <= std::min(int(kWidth) - 1, x + radius); ++u) {
            sum += sums[std::size_t(v) * kWidth + std::size_t(u)];
            count += counts[std::size_t(v) * kWidth + std::size_t(u)];
        }
    }
    return count > 0 ? sum / count : 0;
}

/// Against a box summed in full: eye paths anywhere, several or none in a pixel, which see light
/// themselves and by photons, in two light groups;
/// the box narrows from 12 pixels to 2.
TEST(PixelImportance, WeightsAreOfTheBlurredMean) {
    PixelImportance importance(kWidth, kHeight);
    const EyeImage everywhere = eye_image();
    std::vector<double> sums(kPixels), counts(kPixels);
    double total = 0, paths = 0;
    for (int pass = 1; pass <= 40; ++pass) {
        RandomStream random(1, std::uint64_t(pass), 0, RandomDomain::Guide);
        EyeImage image;
        image.groups = 2;
        std::vector<Rgb> photons;
        for (int i = 0; i < 60; ++i) {
            const Vec2 p{float(kWidth) * random.next(), float(kHeight) * random.next()};
            const float value = p.x * random.next();
            image.positions.push_back(p);
            photons.push_back(kWhite * (value / 2));
            photons.push_back(kWhite * (2 * value));
            image.radiance.push_back(kWhite * (value / 2));
            image.radiance.push_back({});
            const std::size_t pixel = std::size_t(p.y) * kWidth + std::size_t(p.x);
            sums[pixel] += 3 * double(value);
            counts[pixel] += 1;
            total += 3 * double(value);
            paths += 1;
        }
        importance.add_pass(mock::seen_pixels(image, photons, kWidth, kHeight));
        if (pass != 1 && pass != 4 && pass != 40) continue;
        const int radius = pass == 1 ? 12 : pass == 4 ? 6 : 2;
        const auto weights = weights_of(importance, everywhere);
        for (int y = 0; y < int(kHeight); ++y) {
            for (int x = 0; x < int(kWidth); ++x) {
                const double w = weight(box_mean(sums, counts, x, y, radius), total / paths);
                const double found = weights[std::size_t(y) * kWidth + std::size_t(x)];
                ASSERT_NEAR(found, w, 1e-3 * w) << x << ", " << y << " pass " << pass;
            }
        }
    }
}

TEST(PixelImportance, BlackImagesHaveWeights) {
    const EyeImage image = eye_image();
    PixelImportance importance(kWidth, kHeight);
    weights_of(importance, image);
    importance.add_pass(mock::seen_pixels(image, uniform(0), kWidth, kHeight));
    weights_of(importance, image);
    // One pixel is lit: the darkest elsewhere weigh at most 1 / (kDarkestShare mean)^2.
    auto radiance = uniform(0);
    radiance[0] = kWhite;
    importance.add_pass(mock::seen_pixels(image, radiance, kWidth, kHeight));
    const double mean = 0.5 / kPixels;
    const auto weights = weights_of(importance, image);
    EXPECT_NEAR(weights.back() * std::pow(kDarkestShare * mean, 2), 1, 1e-4);
    EXPECT_LT(weights.front(), weights.back());
}

/// Units are the scene's own: luminances whose squares no float holds have weights all the same.
TEST(PixelImportance, ExtremeLuminancesHaveWeights) {
    for (const double value : {1e-30, 1e-22, 1e22, 1e30}) {
        const EyeImage image = eye_image();
        PixelImportance importance(kWidth, kHeight);
        EyeImage first = eye_image();
        first.radiance = uniform(value);
        weights_of(importance, first);
        importance.add_pass(mock::seen_pixels(image, uniform(value), kWidth, kHeight));
        weights_of(importance, image);
    }
}

/// Film positions on the border itself, by rounding, belong to the pixels there.
TEST(PixelImportance, PositionsAtTheFilmsEdge) {
    EyeImage image = eye_image();
    for (Vec2& p : image.positions) {
        if (p.x > kWidth - 1) p.x = kWidth;
        if (p.y > kHeight - 1) p.y = kHeight;
        if (p.x < 1) p.x = -1e-6f;
        if (p.y < 1) p.y = 0;
    }
    const EyeImage centres = eye_image();
    PixelImportance at_edge(kWidth, kHeight), inside(kWidth, kHeight);
    auto radiance = uniform(1);
    for (std::size_t i = 0; i < radiance.size(); ++i)
        radiance[i] = kWhite * float(1 + i % kWidth);
    at_edge.add_pass(mock::seen_pixels(image, radiance, kWidth, kHeight));
    inside.add_pass(mock::seen_pixels(centres, radiance, kWidth, kHeight));
    EXPECT_EQ(weights_of(at_edge, image), weights_of(inside, centres));
}

TEST(PixelImportance, MemoryIsBounded) {
    const EyeImage image = eye_image();
    PixelImportance importance(kWidth, kHeight);
    for (int pass = 0; pass < 3; ++pass)
        importance.add_pass(mock::seen_pixels(image, uniform(1), kWidth, kHeight));
    EXPECT_LE(importance.memory_bytes(), PixelImportance::memory_bound_bytes(kPixels));
}

}  // namespace
}  // namespace aips::pixel_importance_test
