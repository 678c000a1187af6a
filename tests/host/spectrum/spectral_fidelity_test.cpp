// What switches rendering by wavelengths on, and what does not: the measure of how well colours
// stand for spectra.
#include "lxs/spectrum/spectral_fidelity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lxs/spectrum/daylight.h"

namespace lxs::spectral_fidelity_test {
namespace {

SpectralCurve bell(double centre, double width) {
    return {[=](double nm) { return std::exp(-0.5 * std::pow((nm - centre) / width, 2)); }, "bell"};
}

Misrepresentation under(const RepresentedSpectrum& lamp, const RepresentedSpectrum& surface) {
    return worst_pair(std::vector{lamp}, std::vector{surface});
}

double worst_of_lamp(const SpectralCurve& lamp) {
    return worst_pair(std::vector{represented_lamp(lamp)}, plain_surfaces()).difference;
}

TEST(SpectralFidelity, SmoothLampsAreTheirColours) {
    EXPECT_LT(worst_of_lamp({[](double) { return 1.0; }, "flat"}), 0.03);
    EXPECT_LT(worst_of_lamp({[](double nm) { return daylight(nm); }, "D65"}), 1e-3);
    double worst = 0;
    for (double kelvin = 1000; kelvin < 30000; kelvin *= 1.02)
        worst = std::max(worst, worst_of_lamp({blackbody_spectrum(kelvin), "black body"}));
    EXPECT_LT(worst, kTolerated);
    EXPECT_NEAR(worst, 0.097, 0.001);  // as spectral_fidelity.h says
    EXPECT_LT(worst_of_lamp(bell(550, 50)), kTolerated);
}

TEST(SpectralFidelity, LinesAndNarrowBandsAreNot) {
    for (const double nm : {450.0, 532.0, 589.3, 632.8})
        EXPECT_GT(worst_of_lamp(bell(nm, 1.5)), 0.3) << nm;
    // Three bands of a white lamp: it has a colour within the gamut.
    const SpectralCurve triple(
        [](double nm) { return bell(460, 2).at(nm) + bell(540, 2).at(nm) + bell(610, 2).at(nm); },
        "triple");
    EXPECT_GT(worst_of_lamp(triple), 0.2);
    const auto plain = plain_surfaces();
    EXPECT_LT(under(represented_lamp(triple), plain[0]).difference, 1e-3);
}

// What a colour cut off at the gamut's edge loses shows on white already.
TEST(SpectralFidelity, ColoursOutsideOfTheGamutCount) {
    const auto plain = plain_surfaces();
    EXPECT_GT(under(represented_lamp(bell(520, 10)), plain[0]).difference, kTolerated);
}

// A paint that reflects all but the lamp's line: yellow in RGB, black in truth.
TEST(SpectralFidelity, SurfacesCountUnderTheLampsOfTheScene) {
    const SpectralCurve notch(
        [](double nm) { return nm < 500 || std::abs(nm - 589) < 15 ? 0.0 : 0.9; }, "notch");
    const RepresentedSpectrum surface = represented_surface(notch);
    const Misrepresentation sodium = under(represented_lamp(bell(589.3, 1.5)), surface);
    EXPECT_NEAR(sodium.difference, 1, 0.01);
    EXPECT_EQ(sodium.pair, "bell on a surface of notch");
    EXPECT_LT(under(white_lamp(), represented_surface(bell(550, 60))).difference, kTolerated);
}

// Absorption compares by what it leaves of light: twice the coefficient is the same medium.
TEST(SpectralFidelity, MediaCompareByTheirTransmittance) {
    const auto scaled = [](double factor, double width) {
        return SpectralCurve([=](double nm) { return factor * bell(600, width).at(nm); }, "m");
    };
    const double narrow = under(white_lamp(), represented_medium(scaled(1, 8))).difference;
    EXPECT_NEAR(under(white_lamp(), represented_medium(scaled(50, 8))).difference, narrow, 1e-4);
    EXPECT_GT(narrow, kTolerated);
    EXPECT_LT(under(white_lamp(), represented_medium(scaled(1, 80))).difference, kTolerated);
    const SpectralCurve none([](double) { return 0.0; }, "none");
    EXPECT_EQ(under(white_lamp(), represented_medium(none)).difference, 0);
}

}  // namespace
}  // namespace lxs::spectral_fidelity_test
