// Colours survive the way to wavelengths and back: primaries exactly, reflectances within bounds,
// passes in the mean. Without that, a spectral render would differ from an RGB one where nothing
// disperses.
#include "lxs/spectrum/wavelengths.h"

#include <gtest/gtest.h>

#include <set>

#include <cmath>
#include <random>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/daylight.h"
#include "lxs/spectrum/wavelength_density.h"

namespace lxs::wavelengths_test {
namespace {

/// Sum of white light's response times spectrum over the visible range.
template <class Spectrum>
Imath::V3d colour_of(const Spectrum& spectrum) {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += daylight_response(nm) * spectrum(nm);
    return sum;
}

TEST(PrimarySpectra, HaveTheirColours) {
    for (int channel = 0; channel < 3; ++channel) {
        const Imath::V3d colour =
            colour_of([&](double nm) { return primary_spectra(nm)[channel]; });
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(colour[c], c == channel ? 1 : 0, 1e-9) << channel << ", " << c;
    }
}

TEST(PrimarySpectra, LieInTheUnitIntervalAndAddUpToOne) {
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        const Imath::V3d spectra = primary_spectra(nm);
        EXPECT_NEAR(spectra.x + spectra.y + spectra.z, 1, 1e-12) << nm;
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(spectra[c], 0) << nm;
            EXPECT_LE(spectra[c], 1) << nm;
        }
    }
}

// The observer's green curve peaks where it does, and a flat spectrum is a little warmer than D65.
TEST(ColourMatching, IsTheStandardObservers) {
    EXPECT_NEAR(colour_matching(555).y, 1, 0.01);
    EXPECT_NEAR(colour_matching(445).z, 1.78, 0.05);
    Imath::V3d flat(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        flat += colour_matching(nm);
    EXPECT_NEAR(flat.x / flat.y, 1, 0.01);
    EXPECT_NEAR(flat.z / flat.y, 1, 0.01);
    // D65 is the scene's white but for half a percent; rgb_spectra_test has the rest.
    const Imath::V3d rgb = rgb_of_xyz({0.95047, 1, 1.08883});
    EXPECT_NEAR((rgb - Imath::V3d(0.99445, 1.00133, 1.00331)).length(), 0, 1e-4);
}

// D65 by the table's own chromaticity (CIE 15:2004, table T.3): x .3127, y .3290.
TEST(Daylight, IsTheStandardIlluminant) {
    Imath::V3d xyz(0.0);
    double flat = 0;
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        xyz += colour_matching(nm) * daylight(nm);
        flat += colour_matching(nm).y;
    }
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), 0.3127, 1e-4);
    EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), 0.3290, 1e-4);
    EXPECT_NEAR(xyz.y, flat, 1e-9 * flat);
    EXPECT_NEAR((colour_of([](double) { return 1.0; }) - Imath::V3d(1.0)).length(), 0, 1e-12);
}

class WavelengthsOfSeed : public ::testing::TestWithParam<std::uint64_t> {};

// Also what a render of so many passes is off by, at most.
TEST_P(WavelengthsOfSeed, GiveBackColoursInTheMeanOverPasses) {
    for (const Rgb& rgb : {Rgb(1, 1, 1), Rgb(0.8f, 0.3f, 0.1f), Rgb(0.1f, 0.7f, 0.2f),
                           Rgb(0.05f, 0.1f, 0.9f), Rgb(5, 2, 1)}) {
        Imath::V3d sum(0.0);
        constexpr int kPasses = 256;
        for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
            const Wavelengths w = wavelengths_of_pass(GetParam(), pass);
            sum += Imath::V3d(w.values_of(rgb)) * w.to_rgb;
        }
        const double scale = max_component(rgb);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c] / kPasses, rgb[c], 0.01 * scale) << rgb << ", " << c;
    }
}

TEST_P(WavelengthsOfSeed, AreStratifiedAndFollowTheNumberOfThePassAlone) {
    std::set<double> all;
    for (std::uint64_t pass = 0; pass < 100; ++pass) {
        const Wavelengths w = wavelengths_of_pass(GetParam(), pass);
        for (const double nm : w.nm) {
            EXPECT_GE(nm, kFirstVisibleNm);
            EXPECT_LE(nm, kLastVisibleNm);
            all.insert(nm);
        }
        EXPECT_EQ(w.nm, wavelengths_of_pass(GetParam(), pass).nm);
    }
    ASSERT_EQ(all.size(), 300u);
    // The golden ratio's offsets leave no gap: within the eye's range neighbours are close.
    double last = 0;
    for (const double nm : all) {
        if (last > 450 && nm < 640) {
            EXPECT_LT(nm - last, 4);
        }
        last = nm;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, WavelengthsOfSeed, ::testing::Values(0, 1, 77, 123456789012345));

TEST(Wavelengths, KeepReflectancesWithinTheirBounds) {
    for (std::uint64_t pass = 0; pass < 50; ++pass) {
        const Wavelengths w = wavelengths_of_pass(0, pass);
        for (const Rgb& rgb :
             {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(1, 1, 0), Rgb(1, 1, 1)}) {
            const Rgb r = w.values_of(rgb);
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(r[c], 0);
                EXPECT_LE(r[c], 1);
            }
        }
        const Rgb grey = w.values_of(Rgb(7.0f));
        EXPECT_NEAR(grey.x, 7, 1e-5);
        EXPECT_NEAR(grey.z, 7, 1e-5);
    }
}

CurvePointer bell(double centre, double width) {
    return std::make_shared<SpectralCurve>(
        [=](double nm) { return std::exp(-0.5 * std::pow((nm - centre) / width, 2)); }, "bell");
}

std::vector<std::vector<CurvePointer>> lamps_of_scenes() {
    return {{}, {bell(589, 1.5)}, {bell(589, 1.5), bell(436, 1.5), bell(550, 60)}};
}

// What is drawn has the density that it is weighed by.
TEST(WavelengthDensity, InvertsItsDistribution) {
    for (const auto& lamps : lamps_of_scenes()) {
        const WavelengthDensity density(lamps, 0.5);
        double last = density.draw(0).nm;
        EXPECT_NEAR(last, kFirstVisibleNm, 1e-3);
        constexpr int kSteps = 200'000;
        for (int i = 1; i <= kSteps; ++i) {
            const DrawnWavelength drawn = density.draw((i - 1e-9) / kSteps);
            const double middle = density.draw((i - 0.5) / kSteps).density;
            ASSERT_NEAR((drawn.nm - last) * middle * kSteps, 1, 0.02) << drawn.nm;
            last = drawn.nm;
        }
        EXPECT_NEAR(last, kLastVisibleNm, 1e-3);
    }
}

/// Colour of light of spectrum `lamp` on a reflectance `surface` as one pass sees it.
Imath::V3d seen_in_pass(const SpectralCurve& lamp, const SpectralCurve& surface,
                        const Wavelengths& w) {
    return Imath::V3d(lamp.at(w) * surface.at(w)) * w.to_rgb;
}

// z-test of the mean over passes of random offsets against the integral: lines, smooth spectra and
// white, by the eye's density and by those of lamps. Significance 1e-4 for all 54 together.
TEST(WavelengthDensity, PassesAreUnbiased) {
    const SpectralCurve white([](double) { return 1.0; }, "white");
    const std::vector<CurvePointer> spectra{bell(589, 4), bell(500, 40),
                                            std::make_shared<SpectralCurve>(white)};
    std::mt19937_64 seeds(7);
    for (const auto& lamps : lamps_of_scenes()) {
        const WavelengthDensity density(lamps, 0.5);
        for (const CurvePointer& lamp : spectra) {
            for (const SpectralCurve* surface : {&white, spectra[1].get()}) {
                constexpr int kPasses = 20'000;
                Imath::V3d sum(0.0), squares(0.0);
                for (int i = 0; i < kPasses; ++i) {
                    const auto seen =
                        seen_in_pass(*lamp, *surface, wavelengths_of_pass(seeds(), 0, density));
                    sum += seen;
                    squares += seen * seen;
                }
                const Imath::V3d exact =
                    colour_of([&](double nm) { return lamp->at(nm) * surface->at(nm); });
                for (int c = 0; c < 3; ++c) {
                    const double mean = sum[c] / kPasses;
                    const double deviation =
                        std::sqrt((squares[c] / kPasses - mean * mean) / kPasses);
                    // 0.1 %: sums at whole nanometres against integrals.
                    EXPECT_NEAR(mean, exact[c], 4.6 * deviation + 1e-3 * std::abs(exact[c]))
                        << lamps.size() << " lamps, channel " << c;
                }
            }
        }
    }
}

// By the eye's density alone most passes see nothing of a sodium lamp.
TEST(WavelengthDensity, EveryPassSeesALampOfOneLine) {
    const CurvePointer lamp = bell(589, 1.5);
    const SpectralCurve white([](double) { return 1.0; }, "white");
    const WavelengthDensity density(std::vector{lamp}, 0.5);
    const double mean = colour_of([&](double nm) { return lamp->at(nm); }).y;
    for (std::uint64_t pass = 0; pass < 100; ++pass) {
        const Wavelengths w = wavelengths_of_pass(1, pass, density);
        EXPECT_EQ(w.white, Imath::V3d(1.0));
        const double seen = seen_in_pass(*lamp, white, w).y;
        EXPECT_GT(seen, 0.4 * mean) << pass;
        EXPECT_LT(seen, 2.1 * mean) << pass;
    }
}

}  // namespace
}  // namespace lxs::wavelengths_test
