// Velvet's scattering against its closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs::velvet_test {
namespace {

class VelvetTest : public ::testing::Test {
  protected:
    const Bsdf& velvet(double p1, double p2, double p3, double thickness) {
        const auto material = scene_.make_material(
            "velvet", {color("Kd", Rgb(0.8f)), number("p1", p1), number("p2", p2), number("p3", p3),
                       number("thickness", thickness)});
        return *memory_.scatter(*material, shading_point());
    }
    ShadingFixture scene_;
    BsdfMemory memory_;
};

Vec3 inclined(float cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

// Kd d / (4 pi cos_o) over the hemisphere.
TEST_F(VelvetTest, EvenFibresScatterHalfOfWhatTheyMeet) {
    const Bsdf& even = velvet(0, 0, 0, 0.2);
    for (const float cosine : {1.0f, 0.5f, 0.2f}) {
        const Rgb albedo = integrated_albedo(even, inclined(cosine), {0, 0, 1});
        EXPECT_NEAR(albedo.x, 0.8f * 0.2f / (2 * cosine), 2e-3f / cosine) << cosine;
    }
}

// With P1 alone (p1 = 1: 1 + c, c = -wo.wi) the mean of c over the hemisphere around wo is -1/2.
TEST_F(VelvetTest, ForwardFibresSendLessBack) {
    const Rgb albedo = integrated_albedo(velvet(1, 0, 0, 0.2), {0, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(albedo.x, 0.8f * 0.2f / 2 * 0.5f, 1e-3f);
}

// Straight back, c = -1: P1 = -1, P2 = 1, P3 = -1.
TEST_F(VelvetTest, PhaseIsASumOfLegendrePolynomials) {
    const Vec3 up(0, 0, 1);
    const Rgb back = velvet(-2, 20, 2, 0.1).evaluate(up, up, Transport::Radiance, kDiffuse);
    EXPECT_NEAR(back.x, 0.8f * 0.1f * (1 + 2 + 20 - 2) / (4 * std::numbers::pi_v<float>), 1e-6f);
    // Across, c = 0: 1 - p2 / 2 < 0, which no light can be.
    const Rgb across = velvet(-2, 20, 2, 0.1)
                           .evaluate(inclined(0.6f), Vec3(-0.6f, 0, 0.8f).normalized(),
                                     Transport::Radiance, kDiffuse);
    EXPECT_EQ(across, Rgb(0.0f));
}

// f cos_i never exceeds Kd, however thick the layer.
TEST_F(VelvetTest, GrazingViewsAreLimited) {
    const Bsdf& thick = velvet(0, 0, 0, 50);
    const Vec3 wo = inclined(0.1f), wi = inclined(0.5f);
    EXPECT_NEAR(thick.evaluate(wo, wi, Transport::Radiance, kDiffuse).x * 0.5f, 0.8f, 1e-5f);
}

}  // namespace
}  // namespace lxs::velvet_test
