// How the radii of the density estimate go on from pass to pass: all that the modes' estimates
// differ in. The estimate of a pass is sum(f * power) / (pi r^2 N) in each of them, what
// photons bring to the image is the film's mean over passes.
#pragma once

#include <memory>

#include "aips/adapter/scene.h"
#include "aips/core/base/state_archive.h"
#include "estimate/gather.h"
#include "estimate/pass_photons.h"
#include "radii/constants.h"
#include "radii/radius_floor.h"

namespace aips {

class RadiusPolicy {
  public:
    virtual ~RadiusPolicy() = default;
    /// Radii for the next pass, which shoots `photons` onto the visible points of `image` (at
    /// least one); they hold until after_pass().
    virtual GatherRadii before_pass(const PassPhotons& photons, const EyeImage& image) = 0;
    /// Takes note of the photons that the pass has gathered with these radii.
    virtual void after_pass(const PhotonFlux& flux) = 0;
    /// Between passes: saves what later radii rest on, or restores it into a new policy for the
    /// same scene and settings. `image`: of the last eye pass, or when restoring that which is
    /// frozen.
    virtual void state(StateArchive& archive, const EyeImage& image) = 0;
    virtual std::size_t memory_bytes() const = 0;
};

/// For a film of width x height pixels.
std::unique_ptr<RadiusPolicy> make_radius_policy(const Settings& settings, const Scene& scene,
                                                 std::uint32_t width, std::uint32_t height);

/// The smallest radius around beams that cross the scene, scene units: below it single precision
/// ends.
double smallest_radius(const Scene& scene);

/// Radius of the first pass, the same for all visible points: startradius times their mean pixel
/// footprint (width), at least `smallest`.
double initial_radius(const Settings& settings, const EyeImage& image, double smallest);

/// Saves or restores it: 0 before there were visible points, else at least `smallest`.
void state_of_initial_radius(StateArchive& archive, double& radius, double smallest);

/// The same for points with this mean footprint (radius).
double radius_of_footprint(const Settings& settings, double footprint, double smallest);

}  // namespace aips
