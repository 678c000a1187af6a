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

struct Wavelengths {
    std::array<double, 3> nm{};  ///< nanometres
    Imath::M33d from_rgb;        ///< row vector of linear RGB times this: values at the wavelengths
    Imath::M33d to_rgb;          ///< row vector of such values times this: unbiased linear RGB

    /// Spectrum of a colour at the wavelengths: a reflectance, a radiance, an absorption. It lies
    /// between the least and the greatest channel; a grey is flat.
    Rgb values_of(const Rgb& rgb) const;
};

/// The set for pass `pass` of a render with `seed`: three strata of a density like the eye's
/// sensitivity (Radziszewski, Boryczko and Alda 2009, "An improved technique for full spectral
/// rendering"), at offsets that follow the golden ratio from pass to pass. The mean of to_rgb over
/// passes integrates against rgb_response().
Wavelengths wavelengths_of_pass(std::uint64_t seed, std::uint64_t pass);

/// The spectra that stand for pure R, G and B, at `nm`: they lie in [0, 1], add up to 1, and have
/// exactly the colours (1,0,0), (0,1,0), (0,0,1) under rgb_response().
Imath::V3d primary_spectra(double nm);

}  // namespace lxs
