// The lamps of a scene whose light is given as a spectrum, at the wavelengths of the pass.
#pragma once

#include <map>

#include "lxs/spectrum/spectral_curve.h"

namespace lxs {

class SpectralLamps {
  public:
    /// Where to find what `spectrum` has at the wavelengths of the pass; null for a null spectrum.
    /// The value is relative to white light, of luminance 1, and stands at its place for good.
    const Rgb* add(const CurvePointer& spectrum);
    void set_wavelengths(const Wavelengths& wavelengths);

  private:
    struct Lamp {
        SpectralCurve relative;
        Rgb value{0.0f};
    };
    std::map<CurvePointer, Lamp> lamps_;
};

}  // namespace lxs
