// Media: what they absorb and what is warned of.
#include <gtest/gtest.h>

#include <cmath>

#include "lxs/spectrum/wavelengths.h"
#include "shading_fixture.h"

namespace lxs::media_test {
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

TEST_F(MediaTest, HomogeneousAbsorbsAndScatters) {
    const auto medium = scene_.make_medium(
        "homogeneous", {color("sigma_a", Rgb(0.1f)), color("sigma_s", {0.3f, 0.2f, 0}),
                        color("g", {0.5f, 0, -0.5f}), number("fresnel", 1.1)});
    EXPECT_TRUE(medium->scatters());
    EXPECT_EQ(medium->scattering(), Rgb(0.3f, 0.2f, 0));
    EXPECT_NEAR(medium->transmittance(1).x, std::exp(-0.4f), 1e-6f);
    EXPECT_FLOAT_EQ(medium->index(), 1.1f);
    EXPECT_GT(medium->phase(1).x, medium->phase(1).y);
    EXPECT_LT(medium->phase(1).z, medium->phase(1).y);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    EXPECT_FALSE(scene_.make_medium("homogeneous")->scatters());
}

TEST_F(MediaTest, CoefficientsOutOfRangeAreLimited) {
    const auto medium =
        scene_.make_medium("homogeneous", {color("sigma_s", {-1, 1, 1}), color("g", {2, 0, -2})});
    EXPECT_EQ(medium->scattering(), Rgb(0, 1, 1));
    EXPECT_TRUE(std::isfinite(medium->phase(1).x));
    EXPECT_EQ(scene_.diagnostics.warnings.size(), 2u);
}

/// As a homogeneous medium of the colour has it.
TEST_F(MediaTest, HeterogeneousHasSpectraAtWavelengths) {
    const Rgb scattering(0.9f, 0.2f, 0.1f);
    const SceneMedium made =
        scene_.make_scene_medium("heterogeneous", {color("sigma_s", scattering)});
    made.medium->bound(Bounds(Vec3(-1), Vec3(1)), [](int count, const auto& job) {
        for (int i = 0; i < count; ++i)
            job(i);
    });
    EXPECT_EQ(made.medium->scattering_at(Vec3(0)), scattering);
    const Wavelengths wavelengths = wavelengths_of_pass(0, 3);
    made.medium->set_wavelengths(&wavelengths);
    EXPECT_TRUE(made.medium->scattering_at(Vec3(0)).equalWithAbsError(
        wavelengths.values_of(scattering), 1e-5f));
}

}  // namespace
}  // namespace lxs::media_test
