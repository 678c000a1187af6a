// Colours survive the way to wavelengths and back: primaries exactly, reflectances within bounds,
// passes in the mean. Without that, a spectral render would differ from an RGB one where nothing
// disperses.
#include "lxs/spectrum/wavelengths.h"

#include <gtest/gtest.h>

#include <set>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

/// Sum of response times spectrum over the visible range.
template <class Spectrum>
Imath::V3d colour_of(const Spectrum& spectrum) {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += rgb_response(nm) * spectrum(nm);
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
    const Imath::V3d rgb = rgb_of_xyz({0.95047, 1, 1.08883});  // D65
    EXPECT_NEAR((rgb - Imath::V3d(1.0)).length(), 0, 1e-4);
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

}  // namespace
}  // namespace lxs
