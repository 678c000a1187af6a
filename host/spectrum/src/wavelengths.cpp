// The three wavelengths that a pass of a spectral render looks at, in place of R, G and B.
#include "lxs/spectrum/wavelengths.h"

#include <algorithm>
#include <cmath>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/daylight.h"
#include "lxs/spectrum/wavelength_density.h"

namespace lxs {
namespace {

double step_at(double nm, double centre, double width) {
    return 1 / (1 + std::exp((centre - nm) / width));
}

/// A soft partition of the spectrum: long, middle and short waves. Edges were fitted so that
/// primary_spectra(), a mixture of the three, stays in [0, 1].
Imath::V3d bands(double nm) {
    const double above_short = step_at(nm, 490.75, 9.37), is_long = step_at(nm, 590.2, 5.768);
    return {is_long, above_short - is_long, 1 - above_short};
}

/// Mixture of the bands, column c for colour c, that gives back each primary.
Imath::M33d band_mixture() {
    Imath::M33d colour_of_band(0.0);  // [band][channel]
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        const Imath::V3d response = daylight_response(nm), band = bands(nm);
        for (int b = 0; b < 3; ++b) {
            for (int c = 0; c < 3; ++c)
                colour_of_band[b][c] += band[b] * response[c];
        }
    }
    return colour_of_band.inverse();  // [channel][band]
}

double fraction(double x) {
    return x - std::floor(x);
}

}  // namespace

Imath::V3d primary_spectra(double nm) {
    static const Imath::M33d mixture = band_mixture();
    const Imath::V3d band = bands(nm);
    Imath::V3d spectra(0.0);
    for (int c = 0; c < 3; ++c) {
        for (int b = 0; b < 3; ++b)
            spectra[c] += mixture[c][b] * band[b];
    }
    return spectra;
}

Rgb Wavelengths::values_of(const Rgb& rgb) const {
    // A mean of the channels, but for rounding.
    const auto [least, most] = std::minmax({rgb.x, rgb.y, rgb.z});
    const Imath::V3d v = Imath::V3d(rgb) * from_rgb;
    return Rgb(std::clamp(static_cast<float>(v.x), least, most),
               std::clamp(static_cast<float>(v.y), least, most),
               std::clamp(static_cast<float>(v.z), least, most));
}

Wavelengths wavelengths_of_pass(std::uint64_t seed, std::uint64_t pass,
                                const WavelengthDensity& density) {
    constexpr double kGoldenRatio = 0.6180339887498949;
    constexpr double kPlasticRatio = 0.7548776662466927;  // a second direction, for seeds
    const double start = fraction(static_cast<double>(seed % (1u << 20)) * kPlasticRatio);
    const double offset = fraction(start + static_cast<double>(pass % (1u << 30)) * kGoldenRatio);
    Wavelengths set;
    for (int i = 0; i < 3; ++i) {
        const DrawnWavelength drawn = density.draw((i + offset) / 3);
        set.nm[static_cast<std::size_t>(i)] = drawn.nm;
        const Imath::V3d spectra = primary_spectra(drawn.nm);
        const Imath::V3d response = daylight_response(drawn.nm) / (3 * drawn.density);
        for (int c = 0; c < 3; ++c) {
            set.from_rgb[c][i] = spectra[c];
            set.to_rgb[i][c] = response[c];
        }
    }
    if (density.is_the_eyes()) set.white = Imath::V3d(1.0) * set.to_rgb;
    return set;
}

Wavelengths wavelengths_of_pass(std::uint64_t seed, std::uint64_t pass) {
    return wavelengths_of_pass(seed, pass, WavelengthDensity{});
}

}  // namespace lxs
