// Protects the film's colour space: matrices against published ones, and that images follow it.
#include <algorithm>
#include <limits>

#include "color_space.h"

#include <gtest/gtest.h>

#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test::color_space_test {
namespace {

constexpr ColorSpace kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
constexpr ColorSpace kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};

// ITU-R BT.2087-0, section 2: the matrix from BT.709 to BT.2020.
TEST(ColorSpace, MatrixOfThePublishedConversion) {
    const Imath::M33d m = ColorConversion(kRec709, kRec2020).matrix();
    const double published[3][3] = {
        {0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0114}, {0.0164, 0.0880, 0.8956}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_NEAR(m[column][row], published[row][column], 1e-4);
}

// As LuxRender's ColorSystem::Constrain: its image of a wall of (0.5 0 0) is less red than the cut
// of a channel would leave it.
TEST(ColorSpace, ColoursBeyondItKeepTheirLuminanceOnItsBorder) {
    const Rgb green = ColorConversion(kRec2020, kRec709)(Rgb(0, 1, 0));
    // Rec. 2020's green (0.170, 0.797) lies beyond Rec. 709's (0.30, 0.60), the nearest.
    EXPECT_NEAR(green.x, 0, 1e-6);
    EXPECT_NEAR(green.y, 0.6780 / 0.7152, 2e-4);
    EXPECT_NEAR(green.z, 0, 1e-6);

    const ColorConversion to_film(kSceneColors, ColorSpace{});
    const Rgb red = to_film(Rgb(0.5f, 0, 0));
    const Imath::V3d cut = Imath::V3d(0.5, 0, 0) * to_film.matrix();
    EXPECT_LT(cut.y, 0);
    EXPECT_LT(red.x, 0.97 * cut.x);
    EXPECT_NEAR(Imath::V3d(red).dot(to_film.luminance_weights()),
                cut.dot(to_film.luminance_weights()), 1e-6);
    EXPECT_GE(std::min({red.x, red.y, red.z}), 0);
    EXPECT_EQ(to_film(Rgb(-1, 0.1f, 0)), Rgb(0.0f)) << "of no luminance";
}

Rgb pixel_of(std::vector<ParameterValue> values) {
    SceneContents contents = scene_of_size(1, 1);
    values.push_back(integer("xresolution", 1));
    values.push_back(integer("yresolution", 1));
    contents.options["Film"].parameters.values = std::move(values);
    RecordedDiagnostics diagnostics;
    const auto film = make_film(contents, diagnostics);
    EXPECT_TRUE(diagnostics.warnings.empty());
    const std::vector<Vec2> positions{Vec2(0.5f)};
    const std::vector<Rgb> radiance{Rgb(0.5f, 0.25f, 0.125f)};
    film->add_pass({positions, radiance, 1, 1});
    return film->image()[0];
}

TEST(ColorSpace, TheFilmFollowsIt) {
    const auto chromaticity = [](const char* name, const std::array<double, 2>& c) {
        return numbers("float", name, {c[0], c[1]});
    };
    EXPECT_EQ(pixel_of({chromaticity("colorspace_red", kSceneRed),
                        chromaticity("colorspace_green", kSceneGreen),
                        chromaticity("colorspace_blue", kSceneBlue),
                        chromaticity("colorspace_white", kSceneWhite)}),
              Rgb(0.5f, 0.25f, 0.125f))
        << "the scene's own";
    const Rgb wide = pixel_of({numbers("float", "colorspace_red", {0.708, 0.292}),
                               numbers("float", "colorspace_green", {0.170, 0.797}),
                               numbers("float", "colorspace_blue", {0.131, 0.046})});
    const ColorSpace space{kRec2020.red, kRec2020.green, kRec2020.blue, ColorSpace{}.white};
    const Rgb expected = ColorConversion(kSceneColors, space)(Rgb(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(wide, expected);
    EXPECT_LT(wide.x, 0.5f) << "red is less saturated in a wider space";
}

// LuxRender's own default, in which its linear image of white light on grey is (0.9898 1.0027
// 1.0041) times the grey.
TEST(ColorSpace, IsSmptesUnlessTheSceneSaysOtherwise) {
    const ColorConversion to_film(kSceneColors, ColorSpace{});
    const Rgb expected = to_film(Rgb(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(pixel_of({}), expected);
    const Rgb white = to_film(Rgb(1.0f));
    EXPECT_NEAR(white.x, 0.9898, 2e-4);
    EXPECT_NEAR(white.y, 1.0027, 2e-4);
    EXPECT_NEAR(white.z, 1.0041, 2e-4);
}

/// The film's primaries may make a channel brighter than the image has it.
TEST(ColorSpace, WhatIsBrighterThanFloatsHoldStaysFinite) {
    const float most = std::numeric_limits<float>::max();
    const ColorConversion to_film(kSceneColors, ColorSpace{});
    for (const Rgb& colour : {Rgb(most), Rgb(0, most, 0), Rgb(0, 0, most)}) {
        const Rgb film = to_film(colour);
        for (const float value : {film.x, film.y, film.z}) {
            EXPECT_GE(value, 0);
            EXPECT_LE(value, most);
        }
    }
}

TEST(ColorSpace, NonsenseIsRefused) {
    const auto error = [](std::vector<double> red) {
        return input_error([&] { pixel_of({numbers("float", "colorspace_red", std::move(red))}); });
    };
    EXPECT_NE(error({0.31, 0.595}).find("the primaries span no colours"), std::string::npos);
    EXPECT_NE(error({0.3}).find("takes 2 numbers, found 1"), std::string::npos);
}

}  // namespace
}  // namespace lxs::test::color_space_test
