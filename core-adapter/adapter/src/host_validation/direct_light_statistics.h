// What shadow rays bring from one light against what rays see of it, from surfaces of the scene.
#pragma once

#include "direction_proposal.h"
#include "estimate.h"
#include "findings.h"

namespace aips {

struct DirectLightStatistics {
    CheckStatistics deltas, values, pdfs, radiances, missed, unasked, blocked, open, shares, behind,
        coordinates;
    /// Integrals of p q / (p + q) as in ask_bsdf.cpp: by samples, and by directions of density q.
    Estimate by_samples, by_density;
    std::uint32_t places = 0;  ///< that the light reaches
};

/// Looks at an emitter from behind, close to where its photons start: what rays see there, shadow
/// rays must bring. An emitter that sends light from its front alone is not seen by them.
void look_from_behind(const Scene& scene, LightIndex light, float time, RandomStream& random,
                      CheckStatistics& statistics);

/// Asks from the place that `ray` meets: by a few shadow rays for visibility, and if they reach the
/// light and `places` have not been asked yet, by `samples` for all else.
void ask_direct_light(const Scene& scene, LightIndex light, const Ray& ray, std::uint32_t samples,
                      std::uint32_t places, RandomStream& random,
                      DirectLightStatistics& statistics);

}  // namespace aips
