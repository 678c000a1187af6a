// Spectra as functions of the wavelength, and their colours.
#include "lxs/spectrum/spectrum.h"

#include <algorithm>
#include <cmath>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

/// Up to a constant factor.
double planck(double nm, double kelvin) {
    constexpr double kSecondRadiation = 1.438776877e7;  // c2 = h c / k, nm K (CODATA 2018)
    constexpr double kReferenceNm = 560;                // keeps the power of the wavelength small
    // exp(-x) / (1 - exp(-x)): cold bodies run to 0, not over.
    const double x = kSecondRadiation / (nm * kelvin);
    return std::pow(nm / kReferenceNm, -5) * std::exp(-x) / -std::expm1(-x);
}

}  // namespace

Rgb colour_of_light(const Spectrum& spectrum) {
    Imath::V3d xyz(0.0);
    double flat = 0;
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        const Imath::V3d matching = colour_matching(nm);
        xyz += matching * spectrum(nm);
        flat += matching.y;
    }
    return clipped_rgb_of_xyz(xyz / flat);
}

Rgb colour_of_surface(const Spectrum& spectrum) {
    Imath::V3d rgb(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        rgb += rgb_response(nm) * spectrum(nm);
    return Rgb(static_cast<float>(std::max(rgb.x, 0.0)), static_cast<float>(std::max(rgb.y, 0.0)),
               static_cast<float>(std::max(rgb.z, 0.0)));
}

Spectrum blackbody_spectrum(double kelvin) {
    constexpr double kFirstNm = 380, kLastNm = 720;  // LuxRender's range
    // The peak (Wien), or the end of the range that is nearer to it.
    const double peak = std::clamp(2.897771955e6 / kelvin, kFirstNm, kLastNm);
    const double largest = planck(peak, kelvin);
    if (!(largest > 0)) return [](double) { return 0.0; };
    return [kelvin, largest](double nm) { return planck(nm, kelvin) / largest; };
}

Spectrum sampled_spectrum(std::vector<double> nm, std::vector<double> values) {
    return [nm = std::move(nm), values = std::move(values)](double at) {
        const auto above = std::upper_bound(nm.begin(), nm.end(), at);
        if (above == nm.begin()) return 0.0;
        const auto i = static_cast<std::size_t>(above - nm.begin());
        if (above == nm.end()) return at == nm.back() ? values.back() : 0.0;
        const double share = (at - nm[i - 1]) / (nm[i] - nm[i - 1]);
        return values[i - 1] * (1 - share) + values[i] * share;
    };
}

}  // namespace lxs
