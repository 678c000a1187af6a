// How photons and the eye path's bounce share the light on a glossy lobe.
//
// The balance heuristic (Veach 1995) with a fixed density k of photons, so that nothing has to be
// known of how likely they were: of light from a direction that the bounce takes with density p the
// bounce keeps p / (p + k), and photons bring the rest.
#pragma once

#include "aips/adapter/bsdf.h"
#include "aips/core/base/image_part.h"

namespace aips {

/// What photons count for on a glossy lobe, as densities (1 / steradian); 0: the bounce brings all.
struct GlossDensities {
    float caustics = 0;  ///< emitters that light reaches the lobe from by way of specular surfaces
    float indirect = 0;  ///< light that some surface has scattered diffusely or glossily

    float of(ImagePart part) const { return part == ImagePart::Caustics ? caustics : indirect; }
    bool any() const { return caustics > 0 || indirect > 0; }
};

/// The share that is left to a bounce of density `pdf`: on lobes so narrow that hardly a photon
/// comes their way all.
inline float bounce_share(float pdf, float photons) {
    return photons > 0 ? pdf / (pdf + photons) : 1;
}

/// How a visible point's glossy lobes, which bounce the eye path on as well, take photons.
struct PointGloss {
    LobeMask bounce = 0;     ///< what the bounce samples; 0: glossy lobes take all photons or none
    GlossDensities photons;  ///< without them photons bring only what the bounce can't find
    bool learns = false;     ///< whether the point tells of light on these lobes
    float bounce_pdf = 1;    ///< probability that the path bounces
};

}  // namespace aips
