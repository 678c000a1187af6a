// One eye path.
#pragma once

#include <span>

#include "aips/core/sampling/eye_numbers.h"
#include "eye/eye_pass.h"

namespace aips {

/// What one eye path found besides radiance.
struct EyePathResult {
    bool has_visible_point = false;
    VisiblePoint visible_point;
    float footprint = 0;  ///< radius of the pixel's footprint at the visible point
    bool has_beam = false;
    VolumeBeam beam;           ///< of one part of the path within a medium that scatters
    float beam_footprint = 0;  ///< radius of the pixel's footprint at its middle
    LightSample light_sample;  ///< of the first shadow ray, if choices are learned; else pdf is 0
    std::uint32_t rays = 0;
};

/// Follows a camera ray, drawn at surfaces from `numbers`, in media from `random`; adds emission
/// and direct light to `radiance` (one entry a light group). A Bsdf that the visible point needs
/// stays in `arena`, everything else is taken back.
EyePathResult trace_eye_path(const EyePassInput& input, const CameraRay& camera_ray,
                             const EyeNumbers& numbers, RandomStream& random, Refusals& refusals,
                             Arena& arena, std::span<Rgb> radiance);

}  // namespace aips
