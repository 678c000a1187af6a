// From gathered flux to the radiance that photons bring to eye paths.
#pragma once

#include <span>
#include <vector>

#include "estimate/gather.h"

namespace aips {

/// 1 / (pi r^2 N), in double: r^2 times the number of paths leaves the range of float in tiny
/// scenes.
double per_disk_and_path(float radius, std::uint64_t photon_paths);

/// Radiance that photons bring to each eye path, by light group: sum(f * power) / (pi r^2 N), r
/// being the visible point's radius and N the photon paths shot in the pass, at least one.
void estimate_pixels(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                     std::uint64_t photon_paths, InvalidSampleFilter& filter,
                     std::vector<Rgb>& photon_radiance);

/// Luminance of what photons bring by way of visible point `i` with this radius.
double luminance_of_point(const EyeImage& image, const PhotonFlux& flux, std::size_t i,
                          float radius, std::uint64_t photon_paths);

/// The parts of what photons and continued eye paths bring, `photon_radiance`, as [path *
/// kImageParts + ImagePart]. `of_media` has what media bring of direct light and caustics, as [beam
/// * kPhotonParts + ImagePart]. All that is neither is indirect.
void estimate_parts(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                    std::uint64_t photon_paths, std::span<const Rgb> of_media,
                    std::span<const Rgb> photon_radiance, std::vector<Rgb>& parts);

/// What photons bring each eye path, all light groups together; of media, within the sections of
/// its beam.
struct DiscEstimates {
    std::vector<Rgb> whole;  ///< [eye path]: from the whole gather disc
    std::vector<Rgb> half;   ///< [eye path]: from the inner half of its area
};

/// Of surfaces, from a flux that has `inner`; what is not finite is left out of both.
void estimate_discs(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                    std::uint64_t photon_paths, DiscEstimates& discs);

}  // namespace aips
