// The flux of one light through a test surface, by its photons and by what it sends to points.
#pragma once

#include "direction_proposal.h"
#include "findings.h"
#include "octant_estimates.h"

namespace aips {

/// Luminances. Octants are those of the photons' directions as they cross the test surface (lights
/// at infinity) or of where they cross it (others).
struct LightFlux {
    Estimate emitted;  ///< all, whether it crosses the test surface or not
    OctantEstimates by_photons, by_points;
    CheckStatistics values;
};

/// Lights at infinity send their photons through the box around the scene: its projected area
/// times the radiance of each direction. Around other lights there is a sphere at some distance,
/// whose irradiance sample_direct() tells. Nothing of the scene stands in the way of either.
LightFlux measure_flux(const Scene& scene, const Light& light, std::uint32_t samples,
                       RandomStream& random);

}  // namespace aips
