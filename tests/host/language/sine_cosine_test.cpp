// Protects the warps' sine and cosine: right over the whole range, quadrant seams included.
#include "lxs/sdk/sine_cosine.h"

#include <gtest/gtest.h>

namespace lxs::sine_cosine_test {
namespace {

constexpr int kSteps = 1 << 16;

TEST(SineCosine, OfAnOctantIsRightToRounding) {
    for (int i = -kSteps; i <= kSteps; ++i) {
        const float x = static_cast<float>(i) * (std::numbers::pi_v<float> / (4 * kSteps));
        const auto [sine, cosine] = sine_cosine_of_octant(x);
        ASSERT_NEAR(sine, std::sin(double(x)), 1e-7) << x;
        ASSERT_NEAR(cosine, std::cos(double(x)), 1e-7) << x;
    }
}

TEST(SineCosine, OfATurnIsRightInAllQuadrantsAndAtTheirSeams) {
    for (int i = 0; i <= kSteps; ++i) {
        const float u = static_cast<float>(i) / kSteps;
        const auto [sine, cosine] = sine_cosine_of_turn(u);
        ASSERT_NEAR(sine, std::sin(2 * std::numbers::pi * u), 2e-7) << u;
        ASSERT_NEAR(cosine, std::cos(2 * std::numbers::pi * u), 2e-7) << u;
    }
    const auto [sine, cosine] = sine_cosine_of_turn(std::nextafter(1.0f, 0.0f));
    EXPECT_NEAR(sine, 0, 1e-6);
    EXPECT_EQ(cosine, 1);
}

}  // namespace
}  // namespace lxs::sine_cosine_test
