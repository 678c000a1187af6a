// Spectra of lamps by the names that LuxRender's "lampspectrum" knows.
#pragma once

#include <span>
#include <string_view>

#include "lxs/spectrum/spectrum.h"

namespace lxs::shading {

/// How well a lamp's spectrum is known.
enum class LampSource : std::uint8_t {
    BlackBody,   ///< Planck's law at the lamp's usual colour temperature: close for anything hot
    Lines,       ///< of known wavelengths and strengths
    RoughLines,  ///< the element's strongest visible lines, their relative strengths rough figures
    StandIn  ///< a black body of the lamp's nominal colour temperature, in place of its spectrum
};

struct Lamp {
    std::string_view name;
    LampSource source;
    double kelvin;          ///< of black bodies and stand-ins; 0 for lines
    std::string_view note;  ///< where the figures are from
};

/// All lamps, in alphabetical order.
std::span<const Lamp> lamps();

/// Spectrum of `lamp` with a largest value of 1.
Spectrum lamp_spectrum(const Lamp& lamp);

}  // namespace lxs::shading
