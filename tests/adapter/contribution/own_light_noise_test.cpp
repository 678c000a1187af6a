// Protects the noise of what eye paths bring by themselves: light that few passes meet counts in
// full, and single pixels do not decide.
#include "contribution/own_light_noise.h"

#include <gtest/gtest.h>

#include "aips/core/sampling/random.h"
#include "image_of_pixels.h"
#include "render_mock.h"

namespace aips::own_light_noise_test {
namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 48;

/// Of pixels of mean 1, each of which is black but in one pass of `one_of`; the first `worst` also
/// have a dot of 1e4 in one pass of two.
EyeImage pass_of(std::uint64_t pass, double one_of, std::size_t worst = 0) {
    EyeImage image = mock::image_of_pixels(kWidth, kHeight, {});
    for (std::size_t i = 0; i < image.radiance.size(); ++i) {
        RandomStream random(3, pass, i, RandomDomain::Eye);
        const auto u = double(random.next());
        image.radiance[i] = kWhite * (u * one_of < 1 ? float(one_of) : 0.0f);
        if (i < worst && random.next() < 0.5f) image.radiance[i] = kWhite * 1e4f;
    }
    return image;
}

/// Of `passes` passes, by weights of 1.
double measured(double one_of, std::uint64_t passes, std::size_t worst = 0) {
    const PixelImportance importance(kWidth, kHeight);
    OwnLightNoise noise(kWidth, kHeight);
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        noise.add_pass(pass_of(pass, one_of, worst), importance, pass > 0);
    return noise.take();
}

TEST(OwnLightNoise, IsTheVarianceOfAPass) {
    EXPECT_NEAR(measured(2, 64), 1, 0.03);
}

TEST(OwnLightNoise, LightThatFewPassesMeetCountsInFull) {
    // One pixel in 12 meets it in a pass; cut off pass by pass a quarter would be left.
    EXPECT_NEAR(measured(12, 512), 11, 0.3);
}

TEST(OwnLightNoise, SinglePixelsDoNotDecide) {
    constexpr std::size_t kDots = 10;
    EXPECT_NEAR(measured(2, 64, kDots), 1 + kMostOfOwnLight * kDots / (kWidth * kHeight), 0.03);
}

TEST(OwnLightNoise, BeginsAnewWhereItIsTaken) {
    const PixelImportance importance(kWidth, kHeight);
    OwnLightNoise noise(kWidth, kHeight);
    EXPECT_EQ(noise.take(), 0);
    noise.add_pass(pass_of(0, 2), importance, false);
    EXPECT_EQ(noise.take(), 0) << "nothing was compared";
    noise.add_pass(pass_of(1, 2), importance, true);
    EXPECT_GT(noise.take(), 0);
    noise.add_pass(pass_of(1, 2), importance, true);
    EXPECT_EQ(noise.take(), 0) << "what was taken is counted twice";
}

}  // namespace
}  // namespace aips::own_light_noise_test
