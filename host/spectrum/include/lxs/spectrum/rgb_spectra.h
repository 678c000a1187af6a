// Spectra that stand for colours in linear RGB as LuxRender carries them: what it makes of a
// light's L and of a reflectance, and the colours that come back from there.
//
// After Smits 1999, "An RGB to spectrum conversion for reflectances": a colour is a sum of at most
// three of seven base spectra. A saturated colour does not come back as it went in: of a light of
// pure red 95 % are left.
#pragma once

#include <array>
#include <cstddef>

#include "lxs/sdk/types.h"

namespace lxs {

/// Chromaticities x, y of the colours of which a scene's linear RGB is made: the primaries of Rec.
/// 709, which the base spectra were made for, and the white of lights of L 1 1 1, which is about
/// D65.
inline constexpr std::array<double, 2> kSceneRed{0.64, 0.33}, kSceneGreen{0.30, 0.60},
    kSceneBlue{0.15, 0.06}, kSceneWhite{0.313334, 0.329235};

/// Luminance, cd m^-2, of a flat spectrum of 1 W m^-2 sr^-1 nm^-1: 683 lm/W times the integral of
/// the eye's sensitivity. A light's L that is given as a spectrum is radiometric, one that is given
/// as a colour is photometric.
inline constexpr float kLuminanceOfFlatSpectrum = 683 * 106.857f;

/// White, cyan, magenta, yellow, red, green, blue.
inline constexpr std::size_t kColourBases = 7;

/// How much of each base spectrum a colour takes; none is negative if no channel is.
using ColourParts = std::array<double, kColourBases>;
ColourParts parts_of(const Rgb& colour);

/// Base spectra at `nm` nanometres, 0 outside of 380 to 720; they may be a little below 0.
/// A reflectance: white is 1.
double reflectance_base(std::size_t base, double nm);
/// The light of L: white has luminance 1, as a flat spectrum of 1 has.
double illuminant_base(std::size_t base, double nm);

/// The colour of the light whose L is `colour`; greys stay as they are. Components are >= 0.
Rgb colour_of_illuminant(const Rgb& colour);

/// The L, components >= 0, of which the light has `colour`: what colour_of_illuminant() undoes.
Rgb illuminant_of_colour(const Rgb& colour);

/// The colour of the light whose L is `illuminant`, filtered by what LuxRender takes for a
/// reflectance: a pixel of a map or of an image, a surface. Greys under greys are their product;
/// components are >= 0.
Rgb colour_of_filtered_illuminant(const Rgb& filter, const Rgb& illuminant);

}  // namespace lxs
