// Media: what they absorb and what is warned of.
#include <gtest/gtest.h>

#include <cmath>

#include "shading_fixture.h"

namespace lxs {
namespace {

class MediaTest : public ::testing::Test {
  protected:
    ShadingFixture scene_;
};

TEST_F(MediaTest, ClearAbsorbsAndHasAnIndex) {
    const auto medium = scene_.make_medium(
        "clear", {number("fresnel", 1.33), color("absorption", {0.2f, 0.6f, 0})});
    EXPECT_FLOAT_EQ(medium->index(), 1.33f);
    EXPECT_NEAR(medium->transmittance(2).x, std::exp(-0.4f), 1e-6f);
    EXPECT_FLOAT_EQ(medium->transmittance(2).z, 1);
}

TEST_F(MediaTest, ClearTakesTextures) {
    scene_.fresnels["f"] = scene_.make_fresnel("cauchy", {number("index", 1.5)});
    scene_.colors["c"] = scene_.make_color("constant", {color("value", Rgb(0.5f))});
    const auto medium =
        scene_.make_medium("clear", {texture("fresnel", "f"), texture("absorption", "c")});
    EXPECT_NEAR(medium->index(), 1.5f, 0.01f);
    EXPECT_TRUE(medium->absorbs());
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
}

TEST_F(MediaTest, NegativeAbsorptionIsRefused) {
    const auto medium = scene_.make_medium("clear", {color("absorption", {-1, 0, 0})});
    EXPECT_FALSE(medium->absorbs());
    EXPECT_EQ(scene_.diagnostics.warnings.size(), 1u);
}

TEST_F(MediaTest, HomogeneousAbsorbsOnlyAndSaysSo) {
    const auto medium = scene_.make_medium(
        "homogeneous", {color("sigma_a", Rgb(0.1f)), color("sigma_s", Rgb(0.3f))});
    EXPECT_NEAR(medium->transmittance(1).x, std::exp(-0.1f), 1e-6f);
    ASSERT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_EQ(scene_.diagnostics.warnings[0],
              "scattering in media is not rendered yet; only absorption is");
    scene_.make_medium("homogeneous");
    EXPECT_EQ(scene_.diagnostics.warnings.size(), 1u);
}

}  // namespace
}  // namespace lxs
