// What materials say of themselves, read from their parameters, and warn of.
#include <gtest/gtest.h>

#include "bsdf_statistics.h"
#include "bsdfs/fresnel.h"
#include "lxs/scene/constant_texture.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"

namespace lxs::material_test {
namespace {

class MaterialTest : public ::testing::Test {
  protected:
    ShadingFixture scene_;
    BsdfMemory memory_;
};

TEST_F(MaterialTest, MatteIsLambertianUnlessItIsRough) {
    Rgb kd;
    const auto smooth = scene_.make_material("matte");
    ASSERT_TRUE(memory_.scatter(*smooth, shading_point())->lambertian(kd));
    EXPECT_EQ(kd, Rgb(0.9f));
    const auto rough = scene_.make_material("matte", {number("sigma", 20)});
    EXPECT_FALSE(memory_.scatter(*rough, shading_point())->lambertian(kd));
}

TEST_F(MaterialTest, BlackMatteScattersNothing) {
    const auto black = scene_.make_material("matte", {color("Kd", Rgb(0.0f))});
    EXPECT_EQ(memory_.scatter(*black, shading_point()), nullptr);
    EXPECT_EQ(black->facts().lobes, 0);
}

TEST_F(MaterialTest, BlackCoatedBaseHasNoDiffuseLobe) {
    const auto black = scene_.make_material("glossy", {color("Kd", Rgb(0.0f))});
    EXPECT_EQ(black->facts().lobes, kGlossy);
    EXPECT_EQ(memory_.scatter(*black, shading_point())->lobes(), kGlossy);
}

TEST_F(MaterialTest, MixOfMattesIsLambertian) {
    scene_.materials["a"] = scene_.make_material("matte", {color("Kd", {0.8f, 0.2f, 0})});
    scene_.materials["b"] = scene_.make_material("matte", {color("Kd", {0, 0.6f, 0})});
    const auto mix = scene_.make_material(
        "mix", {text("namedmaterial1", "a"), text("namedmaterial2", "b"), number("amount", 0.25)});
    Rgb kd;
    ASSERT_TRUE(memory_.scatter(*mix, shading_point())->lambertian(kd));
    const Rgb mean = colour_of_reflectance({0.8f, 0.2f, 0}) * 0.75f +
                     colour_of_reflectance({0, 0.6f, 0}) * 0.25f;
    EXPECT_NEAR(kd.y, mean.y, 1e-6f);
    EXPECT_GT(kd.x, 0.59f);
}

// A shadow ray meets the side that faces where it comes from, as a path from there does.
TEST_F(MaterialTest, DoubleSideLetsShadowRaysThroughAsItLetsPaths) {
    scene_.materials["matte"] = scene_.make_material("matte");
    scene_.materials["null"] = scene_.make_material("null");
    const auto sheet = scene_.make_material(
        "doubleside", {text("frontnamedmaterial", "null"), text("backnamedmaterial", "matte")});
    ASSERT_TRUE(sheet->facts().straight);
    const Bsdf& bsdf = *memory_.scatter(*sheet, shading_point());
    for (const Vec3& wo : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        bool passes = false;
        for (const float u_lobe : {0.1f, 0.9f}) {  // by which side it is drawn
            BsdfSample sample;
            passes |=
                bsdf.sample(wo, {0.3f, 0.6f}, u_lobe, Transport::Radiance, kAllLobes, sample) &&
                sample.straight;
        }
        EXPECT_EQ(passes, wo.z > 0);
        EXPECT_EQ(sheet->straight_transmittance(shading_point(), -wo).x, passes ? 1 : 0);
    }
}

TEST_F(MaterialTest, MixWithNullLetsItsShareOfShadowRaysThrough) {
    scene_.materials["matte"] = scene_.make_material("matte");
    scene_.materials["null"] = scene_.make_material("null");
    const auto mix = scene_.make_material(
        "mix",
        {text("namedmaterial1", "matte"), text("namedmaterial2", "null"), number("amount", 0.3)});
    EXPECT_TRUE(mix->facts().straight);
    EXPECT_NEAR(mix->straight_transmittance(shading_point(), {0, 0, 1}).x, 0.3f, 1e-6f);
    const MeanWeight mean = mean_weight(*memory_.scatter(*mix, shading_point()), {0, 0, 1},
                                        Transport::Radiance, 10000, 1);
    EXPECT_NEAR(mean.mean.x, 0.3f + 0.7f * 0.9f, 5 * mean.deviation.x);
}

TEST_F(MaterialTest, MixWithoutPartsIsAnError) {
    EXPECT_THROW(scene_.make_material("mix"), InputError);
}

TEST_F(MaterialTest, IndexScalesTheColourOfTheCoating) {
    const auto glossy = scene_.make_material(
        "glossy", {number("index", 1.5), color("Ks", Rgb(0.5f)), color("Kd", Rgb(0.0f))});
    const Bsdf* bsdf = memory_.scatter(*glossy, shading_point());
    EXPECT_NEAR(bsdf->albedo({0, 0, 1}, kAllLobes).x, 0.02f, 0.005f);
}

TEST_F(MaterialTest, SigmaHasNoEffectOnGlossyThatIsNotSeparable) {
    scene_.make_material("glossy", {number("sigma", 20)});
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    scene_.make_material("glossy", {number("sigma", 20), flag("separable", false)});
    ASSERT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_NE(scene_.diagnostics.warnings[0].find("\"sigma\" has no effect"), std::string::npos);
}

TEST_F(MaterialTest, OldNamesAreGlossy) {
    for (const char* name : {"substrate", "plastic"}) {
        const auto material = scene_.make_material(name, {number("roughness", 0.01)});
        EXPECT_EQ(material->facts().lobes, kDiffuse | kGlossy) << name;
    }
    EXPECT_TRUE(scene_.diagnostics.unknown.empty());
}

TEST_F(MaterialTest, SharedParametersOfLuxRenderAreKnownToAll) {
    scene_.materials["m"] = scene_.make_material("matte");
    for (const auto& [name, factory] : scene_.registry.materials) {
        std::vector<ParameterValue> values{flag("compo_visible_material", true),
                                           number("compo_override_alpha_value", 0),
                                           number("bumpmapsampledistance", 0.001)};
        if (name == "doubleside") values.push_back(text("frontnamedmaterial", "m"));
        if (name == "mix") {
            values.push_back(text("namedmaterial1", "m"));
            values.push_back(text("namedmaterial2", "m"));
        }
        if (name == "layered") values.push_back(text("namedmaterial1", "m"));
        if (name == "glossycoating") values.push_back(text("basematerial", "m"));
        EXPECT_NE(scene_.make_material(name, values), nullptr);
    }
    EXPECT_TRUE(scene_.diagnostics.unknown.empty());
}

TEST_F(MaterialTest, CompositingFlagsAreWarnedOfWhereTheyWouldShow) {
    scene_.make_material("matte",
                         {flag("compo_visible_material", true), flag("compo_use_key", false)});
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    scene_.make_material("mirror", {flag("compo_visible_material", false)});
    ASSERT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_EQ(scene_.diagnostics.warnings[0],
              "compositing is not rendered: the surface is seen by all rays");
    EXPECT_EQ(scene_.diagnostics.lines[0], 7u);
}

TEST_F(MaterialTest, WhatIsNotRenderedIsWarnedOf) {
    scene_.make_material("matte", {color("Kd", {1.5f, 0, 0})});
    std::vector<std::string> expected{"\"Kd\" is limited to 0 to 1"};
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
    scene_.colors["bright"] = std::make_shared<ConstantTexture<Rgb>>(Rgb(2.0f));
    scene_.make_material("matte", {texture("Kd", "bright")});
    expected.emplace_back("\"Kd\" is limited to 0 to 1, and texture \"bright\" goes beyond");
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
}

TEST_F(MaterialTest, NumbersBeyondTheirLimitsAreWarnedOf) {
    scene_.make_material("metal", {number("roughness", 3)});
    scene_.make_material("matte", {number("sigma", 90)});
    scene_.make_material("glass", {number("index", 1e9)});
    const std::vector<std::string> expected{"\"roughness\" is limited to 0 to 1",
                                            "\"roughness\" is limited to 0 to 1",
                                            "\"index\" is limited to 0.05 to 20"};
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
}

TEST_F(MaterialTest, UnknownPresetsAreRenderedByTheDefault) {
    EXPECT_THROW(scene_.make_material("metal", {text("name", "unobtainium")}), InputError);
    scene_.diagnostics.lenient = true;
    EXPECT_NE(scene_.make_material("metal", {text("name", "unobtainium")}), nullptr);
    EXPECT_NE(scene_.make_material("carpaint", {text("name", "whit")}), nullptr);
    const std::vector<std::string> expected{
        "unknown metal \"unobtainium\"; known: amorphous carbon, silver, gold, copper, aluminium; "
        "\"aluminium\" is used instead",
        "unknown car paint \"whit\"; did you mean \"white\"? Known: white, ford f8, polaris "
        "silber, opel titan, bmw339, 2k acrylack, blue, blue matte; \"ford f8\" is used instead"};
    EXPECT_EQ(scene_.diagnostics.warnings, expected);
    EXPECT_EQ(scene_.diagnostics.lines[0], 7u);
}

// Colours at normal incidence; SurfaceFormula.MetalPresets has them in figures.
TEST_F(MaterialTest, MeasuredMetalsHaveTheirColours) {
    const auto reflectance = [&](const char* name) {
        const auto fresnel = scene_.make_fresnel("fresnelname", {text("name", name)});
        return shading::fresnel_conductor(1, *fresnel->constant());
    };
    const Rgb silver = reflectance("silver"), gold = reflectance("gold");
    const Rgb copper = reflectance("copper"), aluminium = reflectance("aluminium");
    EXPECT_GT(silver.x, 0.95f);
    EXPECT_NEAR(silver.z, 0.914f, 0.01f);
    EXPECT_GT(gold.x, 0.95f);
    EXPECT_LT(gold.z, 0.45f);
    EXPECT_GT(copper.x, 0.9f);
    EXPECT_LT(copper.y, 0.65f);
    EXPECT_NEAR(aluminium.x, 0.905f, 0.01f);
    EXPECT_NEAR(aluminium.z, 0.923f, 0.01f);
    EXPECT_LT(max_component(reflectance("amorphous carbon")), 0.25f);
}

}  // namespace
}  // namespace lxs::material_test
