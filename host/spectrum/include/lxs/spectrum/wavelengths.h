// The three wavelengths that a pass of a spectral render looks at, in place of R, G and B.
//
// Eye and photon paths of a pass share them, so that densities of photons can be estimated, and an
// Rgb then holds the radiance at each. Colours of the scene become spectra by three smooth bands;
// the film turns what it gathers back into linear RGB. The wavelengths are stratified over passes.
#pragma once

#include <array>
#include <cstdint>

#include "lxs/sdk/types.h"

namespace lxs {

class WavelengthDensity;

struct Wavelengths {
    std::array<double, 3> nm{};  ///< nanometres
    Imath::M33d from_rgb;        ///< row vector of linear RGB times this: values at the wavelengths
    Imath::M33d to_rgb;          ///< row vector of such values times this: unbiased linear RGB
    /// By the mean of which over passes an image may be divided to gain in evenness; its
    /// expectation is 1. What a white of 1 has become; 1 where lines of lamps were looked for:
    /// their light doesn't vary along with white.
    Imath::V3d white{1.0};

    /// Spectrum of a colour at the wavelengths: a reflectance, a radiance, an absorption. It lies
    /// between the least and the greatest channel; a grey is flat.
    Rgb values_of(const Rgb& rgb) const;
};

/// The set for pass `pass` of a render with `seed`: three strata of `density`, at offsets that
/// follow the golden ratio from pass to pass. The mean of to_rgb over passes integrates against
/// daylight_response(): values are relative to white light.
Wavelengths wavelengths_of_pass(std::uint64_t seed, std::uint64_t pass,
                                const WavelengthDensity& density);
/// The same by the eye's density.
Wavelengths wavelengths_of_pass(std::uint64_t seed, std::uint64_t pass);

/// The spectra that stand for pure R, G and B, at `nm`: they lie in [0, 1], add up to 1, and have
/// exactly the colours (1,0,0), (0,1,0), (0,0,1) under daylight_response().
Imath::V3d primary_spectra(double nm);

}  // namespace lxs
