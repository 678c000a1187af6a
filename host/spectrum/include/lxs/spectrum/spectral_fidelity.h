// How well colours stand for spectra: what decides whether a scene is rendered by wavelengths.
//
// A render in RGB knows a lamp's or a paint's spectrum by its colour alone. The smooth spectrum
// that stands for that colour (primary_spectra) takes its place here: the light of a lamp on a
// surface is then compared with that of the true spectra, both as colours in linear RGB.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lxs/spectrum/spectral_curve.h"

namespace lxs {

/// A spectrum and the one that stands for its colour. Lamps are relative to white light and of
/// luminance 1, so that their product with a surface is the light that comes from there.
struct RepresentedSpectrum {
    SpectralTable exact{}, by_colour{};
    std::string name;
};

RepresentedSpectrum represented_lamp(const SpectralCurve& lamp);
RepresentedSpectrum represented_surface(const SpectralCurve& reflectance);
/// What is left of light over a depth that takes 1 / e of it, by the mean of the colour's channels:
/// `coefficient` is an absorption or scattering per unit of distance.
RepresentedSpectrum represented_medium(const SpectralCurve& coefficient);

/// White light, which stands for all lamps whose colours are no spectra.
RepresentedSpectrum white_lamp();
/// White, a red, a green and a blue, which stand for all surfaces whose colours are no spectra: for
/// them the spectrum of a colour is the true one.
std::vector<RepresentedSpectrum> plain_surfaces();

/// A lamp on a surface, and by how much its colour in RGB is wrong.
struct Misrepresentation {
    double difference = 0;  ///< greatest of a channel, as a share of the greatest channel
    std::string pair;       ///< names of both; empty if there are none
};

/// Where the difference is greater, a scene is rendered by wavelengths. Black bodies, the smoothest
/// of lamps, are within it: from 1000 K up by at most 0.097.
inline constexpr double kTolerated = 0.1;

/// The worst of all pairs.
Misrepresentation worst_pair(std::span<const RepresentedSpectrum> lamps,
                             std::span<const RepresentedSpectrum> surfaces);

}  // namespace lxs
