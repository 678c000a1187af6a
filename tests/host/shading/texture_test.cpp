// Textures that are formulas.
#include <gtest/gtest.h>

#include "shading_fixture.h"

namespace lxs::texture_test {
namespace {

TexturePoint at_uv(float u, float v) {
    TexturePoint point;
    point.uv = {u, v};
    return point;
}

class TextureTest : public ::testing::Test {
  protected:
    ShadingFixture scene_;
};

TEST_F(TextureTest, ConstantsAreConstant) {
    EXPECT_EQ(scene_.make_float("constant", {number("value", 3)})->constant(), 3.0f);
    EXPECT_EQ(scene_.make_color("constant", {color("value", {1, 2, 3})})->constant(), Rgb(1, 2, 3));
    EXPECT_EQ(scene_.make_fresnel("constant", {number("value", 1.4)})->constant()->eta, Rgb(1.4f));
}

TEST_F(TextureTest, ScaleMultiplies) {
    const auto scale =
        scene_.make_color("scale", {color("tex1", {0.5f, 1, 2}), color("tex2", {4, 3, 2})});
    EXPECT_EQ(scale->constant(), Rgb(2, 3, 4));
    EXPECT_EQ(scale->evaluate({}), Rgb(2, 3, 4));
}

TEST_F(TextureTest, MixBlends) {
    const auto mix =
        scene_.make_float("mix", {number("tex1", 1), number("tex2", 5), number("amount", 0.25)});
    EXPECT_EQ(mix->constant(), 2.0f);
    scene_.floats["checks"] = scene_.make_float("checkerboard");
    const auto varying = scene_.make_float(
        "mix", {number("tex1", 1), number("tex2", 5), texture("amount", "checks")});
    EXPECT_FALSE(varying->constant());
    EXPECT_EQ(varying->evaluate(at_uv(0.5f, 0.5f)), 5);
    EXPECT_EQ(varying->evaluate(at_uv(1.5f, 0.5f)), 1);
}

TEST_F(TextureTest, CheckerboardAlternatesOnBothSidesOfZero) {
    const auto checks = scene_.make_float("checkerboard", {number("uscale", 2)});
    EXPECT_EQ(checks->evaluate(at_uv(0.1f, 0.1f)), 1);
    EXPECT_EQ(checks->evaluate(at_uv(0.6f, 0.1f)), 0);
    EXPECT_EQ(checks->evaluate(at_uv(-0.1f, 0.1f)), 0);
    EXPECT_EQ(checks->evaluate(at_uv(-0.1f, -0.1f)), 1);
    EXPECT_EQ(checks->evaluate(at_uv(1e30f, 0.1f)), 1);
}

TEST_F(TextureTest, CheckerboardInSpaceFollowsItsTransform) {
    Matrix doubled;
    doubled.scale(Imath::V3d(2));
    const auto checks = scene_.make_float("checkerboard", {integer("dimension", 3)}, doubled);
    TexturePoint point;
    point.p = Vec3(1.9f, 1, 1);
    EXPECT_EQ(checks->evaluate(point), 1);
    point.p = Vec3(2.1f, 1, 1);
    EXPECT_EQ(checks->evaluate(point), 0);
    EXPECT_THROW(scene_.make_float("checkerboard", {integer("dimension", 3)}, Matrix(0.0)),
                 InputError);
    EXPECT_THROW(scene_.make_float("checkerboard", {integer("dimension", 4)}), InputError);
}

TEST_F(TextureTest, FresnelColorOfConstantIsConstant) {
    const auto fresnel = scene_.make_fresnel("fresnelcolor", {color("Kr", {0.8f, 0.5f, 0.3f})});
    ASSERT_TRUE(fresnel->constant());
    EXPECT_TRUE(fresnel->constant()->conductor);
    EXPECT_GT(fresnel->constant()->eta.x, fresnel->constant()->eta.z);
}

TEST_F(TextureTest, CauchyHasItsIndexAtSodiumLight) {
    const auto fresnel =
        scene_.make_fresnel("cauchy", {number("index", 1.6), number("cauchyb", 0.01)});
    const Rgb eta = fresnel->constant()->eta;
    EXPECT_LT(eta.x, 1.6f);  // red is longer than 589 nm
    EXPECT_GT(eta.y, 1.6f);
    EXPECT_GT(eta.z, eta.y);
    EXPECT_THROW(scene_.make_fresnel("cauchy", {number("cauchya", -3)}), InputError);
}

}  // namespace
}  // namespace lxs::texture_test
