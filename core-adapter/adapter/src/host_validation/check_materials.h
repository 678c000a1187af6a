// Bsdfs: sample, pdf and evaluate describe the same function, and lobes() and albedo() tell of it.
#pragma once

#include "met_surfaces.h"

namespace aips {

void check_materials(const Scene& scene, const HostValidationSettings& settings,
                     const MetSurfaces& surfaces, HostFindings& findings);

}  // namespace aips
