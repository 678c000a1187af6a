// Protects spectral rendering end to end: a prism shows its spectrum in the right order, a scene
// that disperses next to nothing looks as it does in RGB, and the bits depend on the seed alone.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <fstream>

#include "block_test.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "lxs/spectrum/spectrum.h"
#include "rendered_image.h"

namespace spectral_test {
namespace {

constexpr const char* kPhotons =
    "--set aips.guide=none --set aips.photonperpass=100000 --set aips.startradius=1.5 ";

struct Colour {
    double r = 0, g = 0, b = 0;
};

/// Sum over the pixels [x0, x1) x [y0, y1), given in thousandths of the image's width.
Colour region(const render::Image& image, int x0, int x1, int y0, int y1) {
    const auto pixel = [&](int thousandths) {
        return static_cast<std::size_t>(thousandths) * image.width / 1000;
    };
    Colour sum;
    for (std::size_t y = pixel(y0); y < pixel(y1); ++y) {
        for (std::size_t x = pixel(x0); x < pixel(x1); ++x) {
            const float* rgb = &image.rgb[3 * (y * image.width + x)];
            sum.r += rgb[0];
            sum.g += rgb[1];
            sum.b += rgb[2];
        }
    }
    return sum;
}

// Short waves are bent most: in the spot on the wall blue lies left of green, green left of red.
TEST(Spectral, APrismShowsItsSpectrum) {
    const render::Folder folder;
    const auto scene = render::small_scene("prism", folder, 200, 150);
    const auto image = render::render(scene, kPhotons + std::string("--passes 24"), folder);
    const Colour left = region(image, 580, 600, 120, 136);
    const Colour middle = region(image, 608, 626, 120, 136);
    const Colour right = region(image, 630, 650, 120, 136);
    EXPECT_GT(left.b, 2 * left.r);
    EXPECT_GT(left.b, 1.5 * left.g);
    EXPECT_GT(middle.g, middle.b);
    EXPECT_GT(right.r, 2 * right.b);
    EXPECT_GT(right.r, 1.5 * right.g);
    EXPECT_GT(middle.g / middle.r, 1.2 * right.g / right.r);
}

// All else being equal: the same scene by wavelengths and in RGB. Interreflection of saturated
// colours differs, as products of spectra are not products of colours.
TEST(Spectral, WithHardlyAnyDispersionTheImageIsThatOfRgb) {
    const render::Folder folder;
    const auto plain = render::small_scene("glass-ball", folder, 96, 72);
    const auto rgb = render::render(plain, kPhotons + std::string("--passes 64"), folder);
    const auto dispersing = render::edited_scene(
        plain, folder,
        {{"\"string type\" [\"glass\"]", "\"string type\" [\"glass\"] \"float cauchyb\" [1e-7]"}});
    const auto spectral = render::render(dispersing, kPhotons + std::string("--passes 64"), folder);
    EXPECT_NE(rgb.rgb, spectral.rgb);
    const double difference =
        statistics::median_difference(spectral.block_means(12), rgb.block_means(12));
    EXPECT_LT(difference, 0.02);
    const Colour a = region(rgb, 0, 1000, 0, 750), b = region(spectral, 0, 1000, 0, 750);
    EXPECT_NEAR(b.r / a.r, 1, 0.03);
    EXPECT_NEAR(b.g / a.g, 1, 0.03);
    EXPECT_NEAR(b.b / a.b, 1, 0.03);
}

/// Floor of `material` under a lamp of emission `light`, both as a scene writes them, seen from
/// above; `more` stands before them.
struct Floor {
    std::string more, light = "\"color L\" [1 1 1]", material = "\"color Kd\" [0.5 0.5 0.5]";
};

struct Rendered {
    render::Image image;
    std::string log;
};

Rendered render_floor(const Floor& floor, int passes) {
    const render::Folder folder;
    const auto scene = folder.path() / "floor.lxs", image = folder.path() / "floor.exr";
    std::ofstream(scene) << fmt::format(
        R"(Film "fleximage" "integer xresolution" [8] "integer yresolution" [8]
  "float colorspace_red" [0.64 0.33] "float colorspace_green" [0.30 0.60]
  "float colorspace_blue" [0.15 0.06] "float colorspace_white" [0.313334 0.329235]
LookAt 0 0 3  0 0 0  0 1 0
Camera "perspective" "float fov" [30]
SurfaceIntegrator "path"
WorldBegin
{}
Material "matte" {}
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3]
  "point P" [-2 -2 0  2 -2 0  2 2 0  -2 2 0]
AreaLightSource "area" {} "float power" [0] "float efficacy" [0] "float gain" [10]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2]
  "point P" [-2 -2 5  2 -2 5  2 2 5  -2 2 5]
WorldEnd
)",
        floor.more, floor.material, floor.light);
    Rendered result;
    result.log =
        render::output_of(fmt::format("{} '{}' -o '{}' --passes {} --seed 3 --verbose 2>&1",
                                      LXSRENDER, scene.string(), image.string(), passes));
    result.image = render::read_image(image);
    return result;
}

bool says(const Rendered& rendered, const std::string& text) {
    return rendered.log.find(text) != std::string::npos;
}

constexpr const char* kSodium = R"(Texture "lamp" "color" "lampspectrum" "string name" ["LPS"])";
constexpr const char* kLamp = R"("texture L" ["lamp"])";

// In closed form: a paint that reflects everything but the light that there is.
TEST(Spectral, APaintThatLacksTheLampsLineIsBlack) {
    const std::string paint =
        R"(Texture "paint" "color" "irregulardata"
  "float wavelengths" [400 500 501 570 571 610 611 700] "float data" [0 0 0.9 0.9 0 0 0.9 0.9]
)";
    const std::string material = R"("texture Kd" ["paint"])";
    const Colour in_white =
        region(render_floor({paint, "\"color L\" [1 1 1]", material}, 64).image, 0, 1000, 0, 1000);
    EXPECT_GT(in_white.r, 10 * in_white.b);
    EXPECT_GT(in_white.g, 10 * in_white.b);
    const Rendered dark = render_floor({paint + kSodium, kLamp, material}, 16);
    const Rendered lit = render_floor({kSodium, kLamp}, 16);
    EXPECT_TRUE(says(dark,
                     "rendering by wavelengths, three a pass, as RGB misrepresents "
                     "lampspectrum \"LPS\" on "))
        << dark.log;
    const Colour black = region(dark.image, 0, 1000, 0, 1000);
    const Colour yellow = region(lit.image, 0, 1000, 0, 1000);
    EXPECT_LT(black.r, 1e-3 * yellow.r);
    EXPECT_LT(black.g, 1e-3 * yellow.g);
    // Light of 589 nm, by the standard observer: x .5752, y .4242, blue outside of the gamut.
    EXPECT_NEAR(yellow.g / yellow.r, 0.5618 / 2.857, 0.03);
    EXPECT_LT(yellow.b, 0.01 * yellow.r);
}

// Greys alone: products of colours are not products of spectra.
TEST(Spectral, AFlatLampLooksAsItDoesInRgb) {
    const std::string flat = R"(Texture "lamp" "color" "equalenergy")";
    const std::string prism =
        "\nAttributeBegin Translate 9 9 9 Material \"glass\" \"float cauchyb\" [0.02] "
        "Shape \"sphere\" \"float radius\" [0.1] AttributeEnd";
    const Rendered rgb = render_floor({flat, kLamp}, 128);
    const Rendered spectral = render_floor({flat + prism, kLamp}, 128);
    EXPECT_TRUE(says(rgb, "RGB represents spectra to ")) << rgb.log;
    EXPECT_TRUE(says(spectral, "as a material disperses light")) << spectral.log;
    const Colour a = region(rgb.image, 0, 1000, 0, 1000);
    const Colour b = region(spectral.image, 0, 1000, 0, 1000);
    EXPECT_NEAR(b.r / a.r, 1, 0.01);
    EXPECT_NEAR(b.g / a.g, 1, 0.01);
    EXPECT_NEAR(b.b / a.b, 1, 0.01);
}

// What RGB represents well enough costs nothing: the bits are those of the spectrum's colour.
TEST(Spectral, SmoothSpectraStayInRgb) {
    const Rendered spectrum = render_floor(
        {R"(Texture "lamp" "color" "blackbody" "float temperature" [2856])", kLamp}, 4);
    const lxs::Rgb rgb =
        lxs::illuminant_of_colour(lxs::colour_of_light(lxs::blackbody_spectrum(2856))) *
        lxs::kLuminanceOfFlatSpectrum;
    const Rendered colour =
        render_floor({"", fmt::format("\"color L\" [{} {} {}]", rgb.x, rgb.y, rgb.z)}, 4);
    ASSERT_EQ(spectrum.image.rgb.size(), colour.image.rgb.size());
    for (std::size_t i = 0; i < colour.image.rgb.size(); ++i)
        ASSERT_NEAR(spectrum.image.rgb[i], colour.image.rgb[i], 1e-4f * colour.image.rgb[i]) << i;
    EXPECT_TRUE(says(spectrum,
                     "wavelengths (nothing disperses; RGB represents spectra to 7.5 %, "
                     "worst blackbody on a green surface)"))
        << spectrum.log;
    EXPECT_TRUE(says(colour, "wavelengths (nothing disperses)")) << colour.log;
}

/// By wavelengths, `volume` "heterogeneous" and "clear" with the same coefficients everywhere.
TEST(Spectral, MediaThatVaryHaveTheColoursOfEvenOnes) {
    const render::Folder folder;
    const auto mean_with = [&](const std::string& volume) {
        const auto scene = folder.write("glow.lxs", R"(LookAt 0 0 5  0 0 0  0 1 0
Camera "perspective" "float fov" [20]
Film "fleximage" "integer xresolution" [16] "integer yresolution" [16]
SurfaceIntegrator "path"
WorldBegin
MakeNamedVolume "glow" )" + volume + R"( "color emission" [0.8 0.4 0.1]
LightSource "infinite" "color L" [0.3 0.6 1]
AttributeBegin
Interior "glow"
Material "null"
Shape "sphere" "float radius" [1]
AttributeEnd
Translate 0 0 40
Material "glass" "float cauchyb" [0.01]
Shape "sphere"
WorldEnd
)");
        return region(render::render(scene, "--passes 40", folder), 0, 1000, 0, 1000);
    };
    const Colour even = mean_with("\"clear\" \"color absorption\" [0 0.5 2]");
    const Colour varying = mean_with("\"heterogeneous\" \"color sigma_a\" [0 0.5 2]");
    EXPECT_NEAR(varying.r, even.r, 0.005 * even.r);
    EXPECT_NEAR(varying.g, even.g, 0.005 * even.g);
    EXPECT_NEAR(varying.b, even.b, 0.005 * even.b);
    EXPECT_GT(even.r, 1.5 * even.g);
}

TEST(Spectral, SameBitsForAnyNumberOfThreads) {
    const render::Folder folder;
    const auto scene = render::small_scene("prism", folder, 64, 48);
    const std::string settings = "--set aips.photonperpass=20000 --passes 10 --threads ";
    EXPECT_EQ(render::render(scene, settings + "1", folder).rgb,
              render::render(scene, settings + "3", folder).rgb);
}

}  // namespace
}  // namespace spectral_test
