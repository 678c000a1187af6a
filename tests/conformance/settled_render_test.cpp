// Protects the checker's budget: it goes on while noise could decide, and no longer.
#include "settled_render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "synthetic_image.h"

namespace conformance::settled_render_test {
namespace {

constexpr Spread kLimit{0.02, 0.06};

bool never(const render::Image& /*image*/) {
    return false;
}

/// A renderer whose pixels have the relative noise `sigma` in one pass.
struct Renderer {
    double sigma;
    std::set<std::size_t> seeds;
    std::size_t renders = 0;

    RenderPasses passes() {
        return [this](std::size_t count, std::size_t seed) {
            seeds.insert(seed);
            ++renders;
            return noisy(smooth_image(), 1, sigma / std::sqrt(double(count)), seed);
        };
    }
};

TEST(SettledRender, StopsAtOnceWhereNothingIsNoisy) {
    Renderer renderer{0.01, {}, 0};
    const SettledImage image = render_settled(renderer.passes(), kLimit, never, Budget{});
    EXPECT_TRUE(image.settled);
    EXPECT_EQ(image.passes, 64u);
    EXPECT_EQ(renderer.renders, 2u);
}

TEST(SettledRender, GoesOnUntilNoiseIsBelowAQuarterOfTheLimits) {
    Renderer renderer{8, {}, 0};
    const SettledImage image = render_settled(renderer.passes(), kLimit, never, Budget{});
    EXPECT_TRUE(image.settled);
    EXPECT_LE(image.noise.median, 0.005);
    EXPECT_LE(image.noise.p95, 0.015);
    // 0.8 / sqrt(passes) a block, of whose normal the quarter of the limits is 0.74 %.
    EXPECT_GT(image.passes, 8000u);
    EXPECT_LT(compare(image.image, smooth_image()).luminance.median, 0.02);
    EXPECT_EQ(renderer.seeds.size(), renderer.renders) << "halves of one seed tell no noise";
}

TEST(SettledRender, AnImageWithinItsLimitsMayKeepTwiceTheNoise) {
    Renderer strict{8, {}, 0}, lenient{8, {}, 0};
    const auto always = [](const render::Image&) { return true; };
    const SettledImage image = render_settled(lenient.passes(), kLimit, always, Budget{});
    EXPECT_TRUE(image.settled);
    EXPECT_LE(image.noise.median, 0.01);
    EXPECT_LT(image.passes, render_settled(strict.passes(), kLimit, never, Budget{}).passes);
}

TEST(SettledRender, StopsBeforeItsTimeIsPassedAndSaysSo) {
    Renderer renderer{1000, {}, 0};
    Budget budget;
    budget.seconds = 1e-9;
    const SettledImage image = render_settled(renderer.passes(), kLimit, never, budget);
    EXPECT_FALSE(image.settled);
    EXPECT_EQ(renderer.renders, 2u);
}

}  // namespace
}  // namespace conformance::settled_render_test
