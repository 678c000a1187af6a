// Protects references that grow: weighted mean, standard error, and that the order and the trip
// through a file's layers change nothing.
#include "weighted_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "synthetic_image.h"

namespace bench::test::weighted_image_test {
namespace {

WeightedImage constant(double value, double weight) {
    return one_chunk(synthetic_image(2, 2, [=](int, int) { return value; }), weight);
}

double pixel(const Image& image) {
    return image.getchannel(0, 0, 0, 0);
}

TEST(WeightedImage, MeanAndStandardErrorHaveTheClosedForm) {
    const WeightedImage all = merge(merge(constant(1, 1), constant(2, 2)), constant(4, 1));
    EXPECT_EQ(all.chunks, 3u);
    EXPECT_EQ(all.weight, 4);
    const double mean = (1 + 2 * 2 + 4) / 4.0;
    EXPECT_NEAR(pixel(all.mean), mean, 1e-6);
    const double squares =
        std::pow(1 - mean, 2) + 2 * std::pow(2 - mean, 2) + std::pow(4 - mean, 2);
    EXPECT_NEAR(pixel(standard_error(all)), std::sqrt(squares / (2 * 4)), 1e-6);
}

TEST(WeightedImage, MergingInOtherGroupsGivesTheSame) {
    const WeightedImage a =
        merge(merge(constant(1, 1), constant(3, 2)), merge(constant(2, 5), constant(7, 3)));
    const WeightedImage b =
        merge(constant(7, 3), merge(constant(2, 5), merge(constant(3, 2), constant(1, 1))));
    EXPECT_NEAR(pixel(a.mean), pixel(b.mean), 1e-6);
    EXPECT_NEAR(pixel(a.squares), pixel(b.squares), 1e-5);
}

TEST(WeightedImage, RestoredFromItsLayersItGrowsAsBefore) {
    const WeightedImage two = merge(constant(1, 1), constant(3, 2));
    const WeightedImage restored = restore(two.mean, standard_error(two), two.weight, two.chunks);
    EXPECT_NEAR(pixel(merge(restored, constant(5, 1)).squares),
                pixel(merge(two, constant(5, 1)).squares), 1e-5);
    const WeightedImage one = constant(1, 4);
    EXPECT_EQ(pixel(restore(one.mean, standard_error(one), 4, 1).squares), 0);
}

TEST(WeightedImage, StandardErrorIsThatOfTheMean) {
    // Chunks of weight w have variance 1 / w. The mean's true deviation is 1 / sqrt(sum of w); the
    // root mean square of 12288 estimates with 5 degrees of freedom is within 2 % of it (3 sigma).
    std::mt19937 random(5);
    WeightedImage all;
    double weights = 0;
    for (const double weight : {1.0, 4.0, 2.0, 8.0, 1.0, 3.0}) {
        const WeightedImage chunk =
            one_chunk(noisy_image(64, 64, 1, 1 / std::sqrt(weight), random), weight);
        all = all.chunks == 0 ? chunk : merge(all, chunk);
        weights += weight;
    }
    const Image error = standard_error(all);
    double squares = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            for (int c = 0; c < 3; ++c)
                squares += std::pow(error.getchannel(x, y, 0, c), 2) / (64 * 64 * 3);
        }
    }
    EXPECT_NEAR(std::sqrt(squares * weights), 1, 0.02);
}

}  // namespace
}  // namespace bench::test::weighted_image_test
