// Colours given as spectra, in lights and on surfaces.
#include <gtest/gtest.h>

#include <cmath>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/spectrum.h"
#include "shading_fixture.h"
#include "temporary_folder.h"
#include "textures/lamp_spectra.h"

namespace lxs::spectral_texture_test {
namespace {

Rgb light_of(const ColorTexture& texture) {
    TexturePoint point;
    point.use = ColourUse::Light;
    return texture.evaluate(point);
}
Rgb surface_of(const ColorTexture& texture) {
    return texture.evaluate({});
}
void expect_near(const Rgb& found, const Rgb& expected, float relative) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], relative * std::abs(expected[c]) + 1e-6f) << found;
}

// Rows of the CIE's table at whole steps, means between them, nothing outside.
TEST(Observer, FollowsTheTableOfTheCie) {
    EXPECT_EQ(colour_matching(555).y, 1);
    EXPECT_EQ(colour_matching(600), Imath::V3d(1.0622, 0.631, 0.0008));
    EXPECT_NEAR(colour_matching(602.5).x, (1.0622 + 1.0456) / 2, 1e-12);
    EXPECT_EQ(colour_matching(379), Imath::V3d(0.0));
    EXPECT_EQ(colour_matching(781), Imath::V3d(0.0));
    Imath::V3d sum(0.0);
    for (double nm = 380; nm <= 780; ++nm)
        sum += colour_matching(nm);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c], 106.857, 0.02);  // CIE 15: equal energy is x = y = 1/3
}

TEST(Spectra, SamplesAreLinearBetweenAndNothingOutside) {
    const Spectrum spectrum = sampled_spectrum({400, 500, 600}, {1, 3, 2});
    EXPECT_EQ(spectrum(400), 1);
    EXPECT_EQ(spectrum(450), 2);
    EXPECT_EQ(spectrum(600), 2);
    EXPECT_EQ(spectrum(399.9), 0);
    EXPECT_EQ(spectrum(600.1), 0);
}

TEST(Spectra, BlackBodiesFollowPlanckAndPeakAtOne) {
    const Spectrum hot = blackbody_spectrum(6500);
    EXPECT_NEAR(hot(2.897771955e6 / 6500), 1, 1e-9);
    constexpr double kC2 = 1.438776877e7;
    EXPECT_NEAR(
        hot(600) / hot(450),
        std::pow(600.0 / 450, -5) * std::expm1(kC2 / (450 * 6500)) / std::expm1(kC2 / (600 * 6500)),
        1e-9);
    EXPECT_NEAR(blackbody_spectrum(2000)(720), 1, 1e-9);  // peaks in the infrared
    EXPECT_EQ(blackbody_spectrum(1)(720), 0);             // too cold for a double
}

class SpectralTextureTest : public ::testing::Test {
  protected:
    files::TemporaryFolder folder_;
    ShadingFixture scene_;
};

// A flat reflectance is white; a flat light is equal energy, XYZ = (1, 1, 1), beside the scene's
// white.
TEST_F(SpectralTextureTest, EqualEnergyIsWhiteOnSurfacesAndReddishAsLight) {
    const auto texture = scene_.make_color("equalenergy", {number("energy", 0.5)});
    expect_near(surface_of(*texture), Rgb(0.5f), 1e-4f);
    expect_near(light_of(*texture), Rgb(0.5f * 1.1981f, 0.5f * 0.9496f, 0.5f * 0.9119f), 1e-3f);
    EXPECT_NEAR(luminance(light_of(*texture)), 0.5f, 1e-3f);
}

// Colours of black bodies: chromaticities of the Planckian locus (CIE 15, appendix E; Wyszecki and
// Stiles 1982, table 1(3.11)): 2856 K x .4476 y .4074, 6500 K x .3135 y .3237.
TEST_F(SpectralTextureTest, BlackBodiesHaveThePlanckianColours) {
    const auto expect_chromaticity = [&](double kelvin, double x, double y) {
        const Rgb found =
            light_of(*scene_.make_color("blackbody", {number("temperature", kelvin)}));
        const Imath::V3d xyz(x / y, 1, (1 - x - y) / y);
        const Rgb expected = clipped_rgb_of_xyz(xyz * luminance(found));
        expect_near(found, expected, 3e-3f);  // the least channel is a difference of large ones
    };
    expect_chromaticity(2856, 0.44757, 0.40745);
    expect_chromaticity(6500, 0.31352, 0.32363);
    EXPECT_THROW(scene_.make_color("blackbody", {number("temperature", 0)}), InputError);
}

// Narrow lights have the luminance of the eye's sensitivity.
TEST_F(SpectralTextureTest, GaussiansHaveTheirWavelengthsColour) {
    const auto green = scene_.make_color(
        "gaussian", {number("energy", 2), number("wavelength", 530), number("width", 3)});
    const Rgb light = light_of(*green);
    EXPECT_EQ(light.x, 0);  // outside of the gamut
    EXPECT_GT(light.y, 10 * light.z);
    // Integral sqrt(2 pi) * width * energy * y(530) over that of the sensitivity; the clipped red
    // channel adds what it takes away from the luminance.
    const double y = 2.5066 * 3 * 2 * 0.862 / 106.857;
    const Imath::V3d xyz = colour_matching(530) * (y / 0.862);
    EXPECT_NEAR(light.y, rgb_of_xyz(xyz).y, 0.01 * light.y);
}

TEST_F(SpectralTextureTest, FrequencyIsASineOverWavelengths) {
    const auto flat = scene_.make_color("frequency", {number("freq", 0), number("phase", 0.5)});
    expect_near(surface_of(*flat), Rgb(static_cast<float>(0.5 + 0.5 * std::sin(0.5))), 1e-4f);
    const auto blue = scene_.make_color("frequency", {number("freq", 0.01), number("phase", 0)});
    const double at_blue = 0.5 + 0.5 * std::sin(4.5), at_red = 0.5 + 0.5 * std::sin(6.1);
    EXPECT_LT(at_blue, at_red);
    EXPECT_LT(surface_of(*blue).z, surface_of(*blue).x);
}

TEST_F(SpectralTextureTest, SampledDataAgreeInAllThreeForms) {
    const std::string path =
        folder_.write("spectrum.txt", "# nm value\n380 0.2\n\n550 0.8 # middle\n720 0.4\n");
    const auto regular = scene_.make_color("regulardata", {numbers("data", {0.2, 0.8, 0.4})});
    const auto irregular = scene_.make_color(
        "irregulardata",
        {numbers("wavelengths", {380, 550, 720}), numbers("data", {0.2, 0.8, 0.4})});
    const auto tabulated = scene_.make_color("tabulateddata", {text("filename", path)});
    EXPECT_EQ(surface_of(*regular), surface_of(*irregular));
    EXPECT_EQ(surface_of(*regular), surface_of(*tabulated));
    EXPECT_EQ(light_of(*regular), light_of(*tabulated));
    const Rgb value = surface_of(*regular);
    EXPECT_GT(value.y, value.x);
    EXPECT_GT(value.y, value.z);
}

TEST_F(SpectralTextureTest, BadDataAreErrorsAndNegativeOnesAreWarnedOf) {
    EXPECT_THROW(scene_.make_color("regulardata"), InputError);
    EXPECT_THROW(scene_.make_color("regulardata", {numbers("data", {1, 2}), number("end", 300)}),
                 InputError);
    EXPECT_THROW(scene_.make_color("irregulardata", {numbers("wavelengths", {400, 500, 600}),
                                                     numbers("data", {1, 2})}),
                 InputError);
    EXPECT_THROW(scene_.make_color("tabulateddata", {text("filename", folder_ / "none.txt")}),
                 InputError);
    const std::string words = folder_.write("words.txt", "380 0.2\n400 dark\n");
    EXPECT_THROW(scene_.make_color("tabulateddata", {text("filename", words)}), InputError);
    scene_.make_color("regulardata", {numbers("data", {1, -2, 1})});
    EXPECT_EQ(scene_.diagnostics.warnings.size(), 1u);
}

TEST_F(SpectralTextureTest, LampsAreKnownOrStandInsWithAWarning) {
    expect_near(light_of(*scene_.make_color("lampspectrum")),
                light_of(*scene_.make_color("blackbody", {number("temperature", 2856)})), 1e-5f);
    const Rgb sodium = light_of(*scene_.make_color("lampspectrum", {text("name", "LPS")}));
    EXPECT_GT(sodium.x, sodium.y);
    EXPECT_LT(sodium.z, 0.01f * sodium.y);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
    scene_.make_color("lampspectrum", {text("name", "HPS")});
    ASSERT_EQ(scene_.diagnostics.warnings.size(), 1u);
    EXPECT_NE(scene_.diagnostics.warnings[0].find("no measured spectrum"), std::string::npos);
    EXPECT_THROW(scene_.make_color("lampspectrum", {text("name", "Sodum")}), InputError);
}

TEST_F(SpectralTextureTest, EveryLampHasALight) {
    std::string_view last;
    for (const shading::Lamp& lamp : shading::lamps()) {
        EXPECT_LT(last, lamp.name);
        last = lamp.name;
        const Spectrum spectrum = shading::lamp_spectrum(lamp);
        EXPECT_GT(luminance(colour_of_light(spectrum)), 1e-3f) << lamp.name;
        for (double nm = 380; nm <= 720; ++nm) {
            EXPECT_GE(spectrum(nm), 0) << lamp.name;
            EXPECT_LE(spectrum(nm), 1.001) << lamp.name;
        }
    }
}

// A spectrum stays one through textures that combine it.
TEST_F(SpectralTextureTest, CombinationsPassOnWhatAColourIsFor) {
    scene_.colors["flat"] = scene_.make_color("equalenergy");
    const auto half =
        scene_.make_color("scale", {texture("tex1", "flat"), color("tex2", Rgb(0.5f))});
    expect_near(*half->constant(), Rgb(0.5f), 1e-4f);
    EXPECT_NEAR(light_of(*half).x, 0.5f * 1.1981f, 1e-3f);
}

TEST_F(SpectralTextureTest, TexturesKeepTheirSpectrumBesideTheColour) {
    const auto bell = scene_.make_color("gaussian", {number("wavelength", 530)});
    ASSERT_NE(bell->spectrum(), nullptr);
    EXPECT_NEAR(bell->spectrum()->at(580.5), std::exp(-0.5 * 1.01 * 1.01), 1e-4);
    EXPECT_EQ(bell->spectrum()->name(), "gaussian");
    const auto lamp = scene_.make_color("lampspectrum", {text("name", "LPS")});
    EXPECT_EQ(lamp->spectrum()->name(), "lampspectrum \"LPS\"");
    EXPECT_EQ(lamp->spectrum()->at(620), 0);
    EXPECT_EQ(scene_.make_color("constant", {color("value", {1, 0, 0})})->spectrum(), nullptr);
}

// Products of spectra are spectra; of a colour, the spectrum that stands for it takes part.
TEST_F(SpectralTextureTest, ScaledSpectraStaySpectra) {
    scene_.colors["bell"] = scene_.make_color("gaussian", {number("wavelength", 530)});
    const auto half =
        scene_.make_color("scale", {texture("tex1", "bell"), color("tex2", Rgb(0.5f))});
    ASSERT_NE(half->spectrum(), nullptr);
    EXPECT_NEAR(half->spectrum()->at(530), 0.5, 1e-6);
    const auto square =
        scene_.make_color("scale", {texture("tex1", "bell"), texture("tex2", "bell")});
    EXPECT_NEAR(square->spectrum()->at(580), std::exp(-1), 1e-6);
    const auto red =
        scene_.make_color("scale", {color("tex1", {1, 0, 0}), texture("tex2", "bell")});
    EXPECT_NEAR(red->spectrum()->at(600),
                primary_spectra(600).x * scene_.colors["bell"]->spectrum()->at(600), 1e-6);
    const auto plain =
        scene_.make_color("scale", {color("tex1", {1, 0, 0}), color("tex2", {0, 1, 0})});
    EXPECT_EQ(plain->spectrum(), nullptr);
    scene_.colors["uv"] = scene_.make_color("uv");
    const auto varying =
        scene_.make_color("scale", {texture("tex1", "uv"), texture("tex2", "bell")});
    EXPECT_EQ(varying->spectrum(), nullptr);
}

// A material has its colour in RGB and its spectrum at wavelengths, within its limits.
TEST_F(SpectralTextureTest, MaterialsUseTheSpectrumAtWavelengths) {
    scene_.colors["bell"] =
        scene_.make_color("gaussian", {number("energy", 1.2), number("wavelength", 560)});
    const auto matte = scene_.make_material("matte", {texture("Kd", "bell")});
    ASSERT_EQ(matte->facts().spectra.size(), 1u);
    BsdfMemory memory;
    ShadingPoint point = shading_point();
    Rgb kd(0.0f);
    ASSERT_TRUE(memory.scatter(*matte, point)->lambertian(kd));
    expect_near(kd,
                Rgb(std::min(surface_of(*scene_.colors["bell"]).x, 1.0f), 1,
                    surface_of(*scene_.colors["bell"]).z),
                1e-6f);
    for (std::uint64_t pass = 0; pass < 8; ++pass) {
        const Wavelengths wavelengths = wavelengths_of_pass(0, pass);
        point.texture.wavelengths = &wavelengths;
        ASSERT_TRUE(memory.scatter(*matte, point)->lambertian(kd));
        for (int i = 0; i < 3; ++i) {
            const double t = (wavelengths.nm[static_cast<std::size_t>(i)] - 560) / 50;
            EXPECT_NEAR(kd[i], std::min(1.2 * std::exp(-0.5 * t * t), 1.0), 2e-4);
        }
    }
    scene_.materials["matte"] = matte;
    const auto mix = scene_.make_material(
        "mix", {text("namedmaterial1", "matte"), text("namedmaterial2", "matte")});
    EXPECT_EQ(mix->facts().spectra.size(), 2u);
}

TEST_F(SpectralTextureTest, ClothTellsOfTheSpectraOfItsYarns) {
    scene_.colors["bell"] =
        scene_.make_color("gaussian", {number("energy", 0.8), number("wavelength", 560)});
    const auto cloth = scene_.make_material(
        "cloth", {text("presetname", "denim"), texture("warp_Kd", "bell"),
                  texture("weft_Ks", "bell"), color("weft_Kd", {0.5, 0.4, 0.3})});
    EXPECT_EQ(cloth->facts().spectra.size(), 2u);
}

TEST_F(SpectralTextureTest, VolumesKeepTheSpectraOfTheirCoefficients) {
    scene_.colors["bell"] = scene_.make_color("gaussian", {number("wavelength", 600)});
    const SceneMedium clear = scene_.make_scene_medium("clear", {texture("absorption", "bell")});
    EXPECT_EQ(clear.spectra.absorption, scene_.colors["bell"]->spectrum());
    const SceneMedium milk = scene_.make_scene_medium(
        "homogeneous", {texture("sigma_s", "bell"), color("sigma_a", Rgb(0.1f))});
    EXPECT_EQ(milk.spectra.scattering, scene_.colors["bell"]->spectrum());
    EXPECT_EQ(milk.spectra.absorption, nullptr);
}

TEST_F(SpectralTextureTest, ColorDepthAbsorbsToItsColour) {
    const auto texture =
        scene_.make_color("colordepth", {number("depth", 2), color("Kt", {0.25f, 1, 0})});
    const Rgb absorption = *texture->constant();
    EXPECT_NEAR(std::exp(-2 * absorption.x), 0.25f, 1e-6f);
    EXPECT_EQ(absorption.y, 0);
    EXPECT_TRUE(std::isfinite(absorption.z));
    EXPECT_LT(std::exp(-2 * absorption.z), 1e-6f);
}

}  // namespace
}  // namespace lxs::spectral_texture_test
