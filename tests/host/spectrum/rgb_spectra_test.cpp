// Protects the spectra of colours: Smits' parts, LuxRender's white, colours that come back.
#include "lxs/spectrum/rgb_spectra.h"

#include <gtest/gtest.h>

#include "lxs/spectrum/colour_matching.h"

namespace lxs::rgb_spectra_test {
namespace {

TEST(RgbSpectra, AColourIsWhiteASecondaryAndAPrimary) {
    const ColourParts parts = parts_of(Rgb(0.2f, 1.0f, 0.5f));
    const ColourParts expected = {0.2, 0.3, 0, 0, 0, 0.5, 0};  // white, cyan, green
    for (std::size_t i = 0; i < kColourBases; ++i)
        EXPECT_NEAR(parts[i], expected[i], 1e-6) << i;
    for (const Rgb& c : {Rgb(1, 2, 3), Rgb(3, 2, 1), Rgb(2, 3, 1), Rgb(2, 1, 3), Rgb(1, 1, 1)}) {
        const std::array<Rgb, kColourBases> bases = {Rgb(1, 1, 1), Rgb(0, 1, 1), Rgb(1, 0, 1),
                                                     Rgb(1, 1, 0), Rgb(1, 0, 0), Rgb(0, 1, 0),
                                                     Rgb(0, 0, 1)};
        const ColourParts of_c = parts_of(c);
        Rgb sum(0.0f);
        for (std::size_t i = 0; i < kColourBases; ++i)
            sum += bases[i] * static_cast<float>(of_c[i]);
        EXPECT_EQ(sum, c);
    }
}

// The white of the scene's colours is the light of L 1 1 1, so that greys stay grey.
TEST(RgbSpectra, WhiteIsTheScenesWhite) {
    Imath::V3d xyz(0.0);
    double flat = 0;
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        xyz += colour_matching(nm) * illuminant_base(0, nm);
        flat += colour_matching(nm).y;
    }
    EXPECT_NEAR(xyz.y / flat, 1, 1e-9);
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), kSceneWhite[0], 1e-4);
    EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), kSceneWhite[1], 1e-4);
    EXPECT_EQ(colour_of_illuminant(Rgb(0.3f)), Rgb(0.3f));
    EXPECT_EQ(colour_of_filtered_illuminant(Rgb(0.5f), Rgb(3.0f)), Rgb(1.5f));
    EXPECT_NEAR(reflectance_base(0, 500), 1, 0.005);
}

TEST(RgbSpectra, TheScenesPrimariesSpanItsMatrix) {
    const std::array<std::array<double, 2>, 4> chromaticities = {kSceneRed, kSceneGreen, kSceneBlue,
                                                                 kSceneWhite};
    for (std::size_t i = 0; i < chromaticities.size(); ++i) {
        const auto& [x, y] = chromaticities[i];
        Imath::V3d rgb = rgb_of_xyz({x / y, 1, (1 - x - y) / y});
        if (i == 3) {
            EXPECT_NEAR((rgb - Imath::V3d(1.0)).length(), 0, 1e-4);
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            if (c != int(i)) {
                EXPECT_NEAR(rgb[c] / rgb[int(i)], 0, 1e-5) << i << c;
            }
        }
    }
}

TEST(RgbSpectra, AnIlluminantIsFoundForAColour) {
    for (const Rgb& l : {Rgb(1, 2, 3), Rgb(5, 1, 1), Rgb(0.2f, 1, 0.3f), Rgb(1, 1, 0.2f)}) {
        const Rgb back = illuminant_of_colour(colour_of_illuminant(l));
        EXPECT_NEAR((back - l).length() / l.length(), 0, 1e-4) << l;
    }
}

}  // namespace
}  // namespace lxs::rgb_spectra_test
