// Textures that combine numbered ones.
#include <gtest/gtest.h>

#include "shading_fixture.h"

namespace lxs::texture_list_test {
namespace {

class TextureListTest : public ::testing::Test {
  protected:
    float band(double amount, const std::vector<double>& offsets) {
        return *scene_
                    .make_float("band", {number("amount", amount), numbers("offsets", offsets),
                                         number("tex1", 1), number("tex2", 3), number("tex3", 4)})
                    ->constant();
    }
    ShadingFixture scene_;
};

TEST_F(TextureListTest, AddAndSubtract) {
    EXPECT_EQ(scene_.make_float("add", {number("tex1", 2), number("tex2", 5)})->constant(), 7.0f);
    EXPECT_EQ(scene_.make_float("subtract", {number("tex1", 2), number("tex2", 5)})->constant(),
              -3.0f);
    EXPECT_EQ(
        scene_.make_color("add", {color("tex1", {1, 2, 3}), color("tex2", {4, 5, 6})})->constant(),
        Rgb(5, 7, 9));
}

TEST_F(TextureListTest, SumsOfVaryingTexturesVary) {
    scene_.floats["checks"] = scene_.make_float("checkerboard");
    const auto sum = scene_.make_float("add", {texture("tex1", "checks"), number("tex2", 5)});
    EXPECT_FALSE(sum->constant());
    TexturePoint point;
    point.uv = {0.5f, 0.5f};
    EXPECT_EQ(sum->evaluate(point), 6);
}

TEST_F(TextureListTest, MultimixIsAWeightedSum) {
    const auto mix =
        scene_.make_color("multimix", {numbers("weights", {0.5, 2, 1}), color("tex1", {2, 0, 0}),
                                       color("tex2", {0, 1, 0}), color("tex3", {0, 1, 1})});
    EXPECT_EQ(mix->constant(), Rgb(1, 3, 1));
    EXPECT_THROW(scene_.make_float("multimix", {numbers("weights", {1, 1}), number("tex1", 1)}),
                 InputError);
    EXPECT_THROW(scene_.make_float("multimix"), InputError);
}

TEST_F(TextureListTest, BandIsLinearBetweenItsOffsets) {
    EXPECT_EQ(band(-1, {0, 0.5, 1}), 1);
    EXPECT_EQ(band(0.25, {0, 0.5, 1}), 2);
    EXPECT_EQ(band(0.5, {0, 0.5, 1}), 3);
    EXPECT_EQ(band(0.75, {0, 0.5, 1}), 3.5f);
    EXPECT_EQ(band(7, {0, 0.5, 1}), 4);
    EXPECT_EQ(band(0.5, {0, 0.5, 0.5}), 4);  // a step
    EXPECT_THROW(band(0.5, {0, 1, 0.5}), InputError);
    EXPECT_THROW(band(0.5, {0, 0.25, 0.5, 1}), InputError);  // no tex4
}

TEST_F(TextureListTest, OpticalConstantsBlendAsFloatsDo) {
    scene_.fresnels["gold"] = scene_.make_fresnel("fresnelname", {text("name", "gold")});
    const FresnelValue gold = *scene_.fresnels["gold"]->constant();
    const std::vector<ParameterValue> glass_and_gold{number("tex1", 1.5), texture("tex2", "gold")};
    const auto with = [&](const char* plugin, std::vector<ParameterValue> more) {
        more.insert(more.end(), glass_and_gold.begin(), glass_and_gold.end());
        return *scene_.make_fresnel(plugin, more)->constant();
    };
    const std::vector<FresnelValue> blends{
        with("mix", {number("amount", 0.25)}), with("multimix", {numbers("weights", {0.75, 0.25})}),
        with("band", {number("amount", 0.5), numbers("offsets", {0, 2})})};
    for (const FresnelValue& value : blends) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(value.eta[i], 0.75f * 1.5f + 0.25f * gold.eta[i], 1e-6f);
            EXPECT_NEAR(value.k[i], 0.25f * gold.k[i], 1e-6f);
        }
        EXPECT_TRUE(value.conductor);
    }
}

TEST_F(TextureListTest, BilinearOpticalConstants) {
    const auto texture = scene_.make_fresnel(
        "bilerp", {number("v00", 1), number("v01", 1), number("v10", 2), number("v11", 3)});
    TexturePoint point;
    point.uv = {0.5f, 0.5f};
    EXPECT_EQ(texture->evaluate(point).eta, Rgb(1.75f));
    EXPECT_FALSE(texture->evaluate(point).conductor);
}

}  // namespace
}  // namespace lxs::texture_list_test
