// A spectrum kept beside its colour, for renders by wavelengths.
#include "lxs/spectrum/spectral_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lxs/spectrum/daylight.h"

namespace lxs {

SpectralCurve::SpectralCurve(const Spectrum& spectrum, std::string name) : name_(std::move(name)) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < kVisibleSteps; ++i) {
        const double value = spectrum(nm_of_step(i));
        const double number = std::isnan(value) ? 0 : std::clamp(value, -kLargest, kLargest);
        values_[i] = static_cast<float>(number);
    }
}

double SpectralCurve::at(double nm) const {
    if (!(nm >= kFirstVisibleNm && nm <= kLastVisibleNm)) return 0;
    const double place = nm - kFirstVisibleNm;
    const std::size_t below = std::min(static_cast<std::size_t>(place), kVisibleSteps - 2);
    const double share = place - static_cast<double>(below);
    return double{values_[below]} * (1 - share) + double{values_[below + 1]} * share;
}

Rgb SpectralCurve::at(const Wavelengths& wavelengths) const {
    return {static_cast<float>(at(wavelengths.nm[0])), static_cast<float>(at(wavelengths.nm[1])),
            static_cast<float>(at(wavelengths.nm[2]))};
}

Rgb SpectralCurve::amounts_at(const Wavelengths& wavelengths) const {
    const Rgb value = at(wavelengths);
    return {std::max(value.x, 0.0f), std::max(value.y, 0.0f), std::max(value.z, 0.0f)};
}

SpectralCurve relative_to_daylight(const SpectralCurve& lamp) {
    double luminance = 0, flat = 0;
    for (std::size_t i = 0; i < kVisibleSteps; ++i) {
        const double sensitivity = colour_matching(nm_of_step(i)).y;
        luminance += sensitivity * lamp.at(nm_of_step(i));
        flat += sensitivity;
    }
    const double scale = luminance > 0 ? flat / luminance : 0;
    return {[&](double nm) { return lamp.at(nm) * scale / daylight(nm); }, lamp.name()};
}

}  // namespace lxs
