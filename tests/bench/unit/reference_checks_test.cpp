// Protects the trust in references: differing ones are found, equal ones pass, the radius' bias is
// measured without the noise of the image that shows it.
#include "reference_checks.h"

#include <gtest/gtest.h>

#include "synthetic_image.h"

namespace bench::test::reference_checks_test {
namespace {

/// "images" with `chunks` chunks each, image 2 brighter by `factor`.
Json images(int chunks, double factor, std::mt19937& random) {
    Json json;
    for (const char* name : kReferenceNames) {
        const double mean = std::string(name) == "2" ? factor : 1;
        json[name]["chunks"] = Json::array();
        for (int i = 0; i < chunks; ++i) {
            json[name]["chunks"].push_back(
                {{"blocks", block_luminances(noisy_image(32, 32, mean, 0.2, random))}});
        }
    }
    return json;
}

TEST(ReferenceChecks, EqualReferencesAgreeAndDifferentOnesDoNot) {
    std::mt19937 random(1);
    EXPECT_TRUE(agreement(images(6, 1, random)).at("agree"));
    const Json different = agreement(images(6, 1.1, random));
    EXPECT_FALSE(different.at("agree"));
    EXPECT_NEAR(different.at("mean_ratio"), 1.1, 0.01);
}

TEST(ReferenceChecks, TooFewChunksSayNothing) {
    std::mt19937 random(2);
    EXPECT_TRUE(agreement(images(2, 1, random)).is_null());
    EXPECT_TRUE(agreement(Json::object()).is_null());
}

TEST(ReferenceChecks, BlocksCoverTheImageRowByRow) {
    const Image image = synthetic_image(16, 24, [](int x, int y) { return x / 2 + 10 * (y / 3); });
    const auto blocks = block_luminances(image);
    ASSERT_EQ(blocks.size(), 64u);
    EXPECT_NEAR(blocks[0], 0, 1e-5);
    EXPECT_NEAR(blocks[7], 7, 1e-5);
    EXPECT_NEAR(blocks[8 * 3 + 2], 32, 1e-4);
    EXPECT_NEAR(blocks[63], 77, 1e-4);
}

TEST(ReferenceChecks, BiasLeftIsFreeOfTheHalvedImagesNoise) {
    std::mt19937 random(3);
    const ReferencePair references{noisy_image(96, 96, 2, 0.05, random),
                                   noisy_image(96, 96, 2, 0.05, random)};
    WeightedImage halved = one_chunk(noisy_image(96, 96, 2.1, 0.4, random), 1);
    for (int i = 1; i < 8; ++i)
        halved = merge(halved, one_chunk(noisy_image(96, 96, 2.1, 0.4, random), 1));
    // Without the correction the figure would be (0.01 + 0.16 / 8) / 4 = 0.0075.
    const Json bias = bias_left(references, halved);
    EXPECT_NEAR(bias.at("relmse"), 0.01 / 4, 0.0004);
    EXPECT_NEAR(bias.at("mean_ratio"), 1.05, 0.002);
}

}  // namespace
}  // namespace bench::test::reference_checks_test
