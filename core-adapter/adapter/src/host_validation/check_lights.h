// Lights: what they emit, what shadow rays bring from them and what rays see of them is the same.
#pragma once

#include "met_surfaces.h"

namespace aips {

void check_lights(const Scene& scene, const HostValidationSettings& settings,
                  const MetSurfaces& surfaces, HostFindings& findings);

}  // namespace aips
