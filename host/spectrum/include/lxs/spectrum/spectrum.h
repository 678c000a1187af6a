// Spectra as functions of the wavelength, and their colours.
#pragma once

#include <functional>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Value at a wavelength in nanometres; finite and >= 0.
using Spectrum = std::function<double(double nm)>;

/// Linear RGB of light: a flat spectrum of 1 has luminance 1 and the (reddish) colour of equal
/// energy, seen by an eye that is adapted to D65. What lies outside of the gamut is clipped.
Rgb colour_of_light(const Spectrum& spectrum);

/// Linear RGB of a reflectance, transmittance or absorption: a flat spectrum of 1 is (1, 1, 1).
Rgb colour_of_surface(const Spectrum& spectrum);

/// Planck's law at `kelvin`, scaled to a largest value of 1 between 380 and 720 nm.
Spectrum blackbody_spectrum(double kelvin);

/// Linear between samples, 0 outside of them. `nm` rises and is as long as `values`.
Spectrum sampled_spectrum(std::vector<double> nm, std::vector<double> values);

}  // namespace lxs
