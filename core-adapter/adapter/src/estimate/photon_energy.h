// What the photons of each light bring to the image, by some of the visible points.
#pragma once

#include "aips/core/photon_map/photon_grid.h"
#include "base/luminance_by_light.h"
#include "estimate/gather_radii.h"
#include "estimate/photon_occlusion.h"
#include "eye/eye_pass.h"

namespace aips {

/// Adds luminance * number of photon paths that the photons bring to the visible points that tell
/// lights apart. `grid` has sorted `photons`; `occlusion` as for gather_photons(). The result does
/// not depend on the number of threads.
void add_photon_energy(const EyeImage& image, const PhotonGrid& grid,
                       std::span<const Photon> photons, const GatherRadii& radii,
                       const PhotonOcclusion* occlusion, LuminanceByLight& sums);

}  // namespace aips
