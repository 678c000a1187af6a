// Interference colours of a thin film on a reflecting surface.
// Sources: Born & Wolf, Principles of Optics, section 7.2 (two beams) and 7.6.1 (why not Airy's
// sum, below); Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling
// of Varying Iridescence", section 4 (the spectral mean of a cosine as a function of the path).
#pragma once

#include "lxs/sdk/types.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs::shading {

/// Two beams of equal strength: a reflectance is multiplied by cos^2(4 pi d s / wavelength) with
/// s = sqrt(filmindex^2 - sin^2), the mean of which over all wavelengths gives the colour.
///
/// The materials that have a film in LuxRender say what they reflect, not what they are made of.
/// Airy's sum needs the substrate's phase, and a film without losses on a perfect mirror shows no
/// colour at all by it; LuxRender's mirrors do. The phase is LuxRender's, twice that of the path
/// 2 d s; no image of it was at hand to check it against.
struct ThinFilm {
    float thickness = 0;  ///< nanometres; 0: none
    float index = 1.5f;
    const Wavelengths* wavelengths = nullptr;  ///< of the pass; null for R, G and B

    /// Share of the reflected light that is left per channel, in [0, 1], under the cosine `c`.
    Rgb filter(float c) const;
};

/// The same at one wavelength (nanometres).
double film_share(const ThinFilm& film, double c, double wavelength);

}  // namespace lxs::shading
