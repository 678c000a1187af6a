// "glossycoating" over bases of all kinds.
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"

namespace lxs::coating_test {
namespace {

const std::vector<ParameterValue> kCoat{color("Ks", {0.06f, 0.1f, 0.2f}),
                                        color("Ka", {0.2f, 0.4f, 0.6f}), number("d", 0.5),
                                        number("uroughness", 0.2), number("vroughness", 0.2)};

class CoatingTest : public ::testing::Test {
  protected:
    std::shared_ptr<const Material> over(const std::string& base) {
        std::vector<ParameterValue> values = kCoat;
        values.push_back(text("basematerial", base));
        return scene_.make_material("glossycoating", values);
    }

    ShadingFixture scene_;
    BsdfMemory memory_;
};

// LuxRender's documentation: over matte the result is that of the regular glossy material.
TEST_F(CoatingTest, OverMatteItIsGlossy) {
    scene_.materials["matte"] = scene_.make_material("matte", {color("Kd", {0.9f, 0.5f, 0.2f})});
    std::vector<ParameterValue> values = kCoat;
    values.push_back(color("Kd", {0.9f, 0.5f, 0.2f}));
    const Bsdf& glossy = *memory_.scatter(*scene_.make_material("glossy", values), shading_point());
    const Bsdf& coated = *memory_.scatter(*over("matte"), shading_point());
    UniformSource u(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 wo = u.direction(), wi = u.direction();
        const Rgb a = glossy.evaluate(wo, wi, Transport::Radiance, kAllLobes);
        const Rgb b = coated.evaluate(wo, wi, Transport::Radiance, kAllLobes);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(a[c], b[c], 1e-4f * a[c] + 1e-6f);
    }
}

TEST_F(CoatingTest, ANullBaseLetsShadowRaysThroughAsItLetsPaths) {
    scene_.materials["null"] = scene_.make_material("null");
    const auto coat = over("null");
    ASSERT_TRUE(coat->facts().straight);
    const Rgb share = coat->straight_transmittance(shading_point(), {0, 0, 1});
    // LuxRender's filter: the root of what comes in, and absorption along both directions.
    const float ks = colour_of_reflectance({0.06f, 0.1f, 0.2f}).x;
    EXPECT_NEAR(share.x, std::sqrt(1 - ks) * std::exp(-0.2f), 1e-5f);
    BsdfSample sample;
    const Bsdf& bsdf = *memory_.scatter(*coat, shading_point());
    ASSERT_TRUE(bsdf.sample({0, 0, 1}, {0.5f, 0.5f}, 0.99f, Transport::Power, kSpecular, sample));
    EXPECT_TRUE(sample.straight);
    EXPECT_NEAR(sample.weight.x, share.x, 1e-5f);
}

TEST_F(CoatingTest, ABaseIsNeeded) {
    EXPECT_THROW(scene_.make_material("glossycoating", kCoat), InputError);
}

}  // namespace
}  // namespace lxs::coating_test
