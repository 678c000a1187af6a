// The density over wavelengths that the passes of a spectral render draw theirs from.
#pragma once

#include <span>
#include <vector>

#include "lxs/spectrum/spectral_curve.h"

namespace lxs {

struct DrawnWavelength {
    double nm = 0;       ///< within the visible range
    double density = 0;  ///< per nanometre, > 0
};

/// By default like the eye's sensitivity (Radziszewski, Boryczko and Alda 2009, "An improved
/// technique for full spectral rendering"). Lines of lamps, which that rarely meets, get a share of
/// all wavelengths: the sum of the lamps' spectra, each weighed by the eye and made as large as the
/// others, however dim the lamp: it may be all the light of a room.
class WavelengthDensity {
  public:
    WavelengthDensity() = default;
    /// `lamp_share` in [0, 1): of the lamps. What the eye sees nothing of is left out.
    WavelengthDensity(std::span<const CurvePointer> lamps, double lamp_share);

    /// No lamp is looked for.
    bool is_the_eyes() const { return density_.empty(); }

    /// Inverts the distribution at `u` in [0, 1): longer waves for larger u.
    DrawnWavelength draw(double u) const;

  private:
    // Piecewise linear; empty for the eye alone, which has a formula.
    std::vector<double> density_;     ///< at whole nanometres
    std::vector<double> cumulative_;  ///< integral up to there; the last one is 1
};

}  // namespace lxs
