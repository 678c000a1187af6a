// What the photons of each light bring to the image, by some of the visible points.
#pragma once

#include "aips/core/photon_map/photon_grid.h"
#include "base/luminance_by_light.h"
#include "estimate/photon_occlusion.h"
#include "estimate/search_radii.h"
#include "eye/eye_pass.h"

namespace aips {

/// Adds luminance * number of photon paths that the landings bring to the visible points that tell
/// lights apart. `grid` has sorted `landings`; `occlusion` as for gather_photons(). The result does
/// not depend on the number of threads.
void add_photon_energy(const EyeImage& image, const LandingGrid& grid,
                       std::span<const Landing> landings, const SearchRadii& radii,
                       const PhotonOcclusion* occlusion, LuminanceByLight& sums);

}  // namespace aips
