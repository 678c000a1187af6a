// A spectrum kept beside its colour, for renders by wavelengths.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/spectrum.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

/// Whole nanometres of the visible range.
inline constexpr std::size_t kVisibleSteps =
    static_cast<std::size_t>(kLastVisibleNm - kFirstVisibleNm) + 1;

/// A value at each of them, as sums over the spectrum go.
using SpectralTable = std::array<double, kVisibleSteps>;

inline double nm_of_step(std::size_t i) {
    return kFirstVisibleNm + static_cast<double>(i);
}

/// A spectrum by its values at whole nanometres, linear in between, 0 outside of visible light.
class SpectralCurve {
  public:
    /// `name`: what messages call it, such as the texture plugin that gave it.
    SpectralCurve(const Spectrum& spectrum, std::string name);

    double at(double nm) const;
    /// At the wavelengths of a pass.
    Rgb at(const Wavelengths& wavelengths) const;
    /// The same of what can't be negative, such as light: 0 where the curve is below 0.
    Rgb amounts_at(const Wavelengths& wavelengths) const;
    const std::string& name() const { return name_; }

  private:
    std::array<float, kVisibleSteps> values_;  ///< finite
    std::string name_;
};

using CurvePointer = std::shared_ptr<const SpectralCurve>;

/// A lamp's spectrum relative to white light, with luminance 1; all 0 if nobody sees it.
SpectralCurve relative_to_daylight(const SpectralCurve& lamp);

}  // namespace lxs
