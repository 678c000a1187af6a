// The density over wavelengths that the passes of a spectral render draw theirs from.
#include "lxs/spectrum/wavelength_density.h"

#include <algorithm>
#include <cmath>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

constexpr double kCentreNm = 538, kSharpness = 0.0072, kNormalisation = 0.0039398042;

double eye_density(double nm) {
    const double c = std::cosh(kSharpness * (nm - kCentreNm));
    return kNormalisation / (c * c);
}

double draw_by_eye(double u) {
    return kCentreNm - std::atanh(0.85691062 - 1.82750197 * u) / kSharpness;
}

/// How much of the light of a wavelength shows in any channel.
double visibility(double nm) {
    const Imath::V3d rgb = rgb_of_xyz(colour_matching(nm));
    return std::abs(rgb.x) + std::abs(rgb.y) + std::abs(rgb.z);
}

/// Integral of linear pieces between whole nanometres, up to each of them.
std::vector<double> integrals(const std::vector<double>& values) {
    std::vector<double> sums(values.size());
    for (std::size_t i = 1; i < values.size(); ++i)
        sums[i] = sums[i - 1] + 0.5 * (values[i - 1] + values[i]);
    return sums;
}

/// What of a lamp's light is seen, by wavelength; its integral is 1. Empty if nothing is.
std::vector<double> seen_of(const SpectralCurve& lamp) {
    std::vector<double> seen(kVisibleSteps);
    for (std::size_t i = 0; i < kVisibleSteps; ++i)
        seen[i] = std::max(lamp.at(nm_of_step(i)), 0.0) * visibility(nm_of_step(i));
    const double sum = integrals(seen).back();
    if (!(sum > 0)) return {};
    for (double& value : seen)
        value /= sum;
    return seen;
}

}  // namespace

WavelengthDensity::WavelengthDensity(std::span<const CurvePointer> lamps, double lamp_share) {
    std::vector<double> sum(kVisibleSteps);
    double count = 0;
    for (const CurvePointer& lamp : lamps) {
        const std::vector<double> seen = seen_of(*lamp);
        for (std::size_t i = 0; i < seen.size(); ++i)
            sum[i] += seen[i];
        count += seen.empty() ? 0 : 1;
    }
    if (count == 0) return;
    for (std::size_t i = 0; i < kVisibleSteps; ++i)
        sum[i] = (1 - lamp_share) * eye_density(nm_of_step(i)) + lamp_share * sum[i] / count;
    const double whole = integrals(sum).back();
    for (double& value : sum)
        value /= whole;
    cumulative_ = integrals(sum);
    density_ = std::move(sum);
}

DrawnWavelength WavelengthDensity::draw(double u) const {
    if (density_.empty()) {
        const double nm = draw_by_eye(u);
        return {nm, eye_density(nm)};
    }
    const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
    const auto i = static_cast<std::size_t>(above - cumulative_.begin() - 1);
    // u - cumulative = a x + (b - a) x^2 / 2, solved without cancellation.
    const double rest = std::max(u - cumulative_[i], 0.0);
    const double a = density_[i], slope = density_[i + 1] - a;
    const double root = std::sqrt(std::max(a * a + 2 * slope * rest, 0.0));
    const double x = std::min(2 * rest / (a + root), 1.0);
    return {nm_of_step(i) + x, a + slope * x};
}

}  // namespace lxs
