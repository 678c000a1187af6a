// Intensity of lights at a point from colour, gain, power and efficacy.
#pragma once

#include "light_statement.h"

namespace lxs {

/// `color` times gain in W/sr; or, where power and efficacy are above 0, `color` scaled so that a
/// light that emits `unscaled` lumens by `color` alone emits gain x power x efficacy.
inline Rgb point_intensity(const LightStatement& s, const Rgb& color, double unscaled) {
    const double lumens = s.number("power", 0) * s.number("efficacy", 0);
    const double gain = s.number("gain", 1);
    const bool by_flux = lumens > 0 && unscaled > 0;
    return s.cleaned(color * static_cast<float>(by_flux ? gain * lumens / unscaled : gain), "gain");
}

}  // namespace lxs
