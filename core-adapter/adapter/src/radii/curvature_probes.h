// Probes of the photon density around visible points: discs wider than the gather radius.
#pragma once

#include <span>

#include "aips/core/radii/optimal_radius.h"
#include "estimate/gather.h"

namespace aips {

/// Adds the photons in `grid` to the probes that `radii` asks for: sums[i] belongs to visible
/// point radii.probes[i]. A photon contributes the luminance of what it brings to the eye path,
/// before division by disc and paths; it is taken as gather_photons takes it with
/// `occlusion`. Every probe sums its
/// photons in the grid's order, so the result does not depend on the number of threads.
void gather_probes(const EyeImage& image, const PhotonGrid& grid, const GatherRadii& radii,
                   const PhotonOcclusion* occlusion, std::span<ProbeSums> sums);

}  // namespace aips
