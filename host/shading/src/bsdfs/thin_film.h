// Interference colours of a thin film on a reflecting surface.
// Sources: Born & Wolf, Principles of Optics, sections 7.2 (two beams) and 7.6.1 (Airy's sum);
// Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling
// of Varying Iridescence", section 4 (the spectral mean of a cosine as a function of the path).
#pragma once

#include "lxs/sdk/types.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs::shading {

/// Two beams of equal strength, reflected at the film's two sides, which differ in their path by
/// 2 d s, s = sqrt(filmindex^2 - sin^2): a reflectance is multiplied by cos^2(2 pi d s /
/// wavelength) (both sides reflect at a denser medium, so that neither phase jumps against the
/// other), the mean of which over all wavelengths gives the colour.
///
/// The materials that have a film in LuxRender say what they reflect, not what they are made of;
/// Airy's sum needs the substrate's indices, and a film without losses on a perfect mirror shows no
/// colour at all by it. No image of LuxRender's films was at hand to compare with.
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
