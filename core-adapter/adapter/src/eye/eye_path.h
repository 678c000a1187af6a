// One eye path.
#pragma once

#include <span>

#include "aips/core/sampling/eye_numbers.h"
#include "eye/eye_pass.h"
#include "views/light_target.h"

namespace aips {

/// Where an eye path has photons gathered.
struct PathPoint {
    bool usable = false;  ///< else there is none
    VisiblePoint point;
    float footprint = 0;  ///< radius of the pixel's footprint there
};

/// What one eye path found besides radiance.
struct EyePathResult {
    PathPoint before;  ///< from which it bounced on, beside that
    PathPoint end;     ///< where it ended
    bool has_beam = false;
    VolumeBeam beam;           ///< of one part of the path within a medium that scatters
    float beam_footprint = 0;  ///< radius of the pixel's footprint at its middle
    LightSample light_sample;  ///< of the first shadow ray, if choices are learned; else pdf is 0
    std::uint32_t rays = 0;
    bool cut = false;  ///< ended at a specular surface by the depth limit
};

/// Where an eye path's light goes.
struct EyePathOutput {
    LightSums radiance = {};  ///< emission and direct light
    /// [light group]: emitters behind specular surfaces; empty: in radiance.
    std::span<Rgb> emitters = {};
    std::span<Rgb> continued = {};  ///< [light group]: EyeImage::continued; empty without shares
    LuminanceByLight* emitter_light = nullptr;  ///< the same of `emitters`, or of all
    /// Takes luminances by light, without shares; null: not asked for.
    LuminanceByLight* light = nullptr;
    Vec2 film = {};                  ///< where it comes from
    bool explores = false;           ///< goes on from its visible point even where it has no share
    bool learns_gloss = false;       ///< its points tell of caustics on glossy lobes
    SeenSurface* surface = nullptr;  ///< null: not wanted
};

/// Follows a camera ray, drawn at surfaces from `numbers`, in media from `random`; adds what it
/// finds to `output`. A Bsdf that the visible point needs
/// stays in `arena`, everything else is taken back.
EyePathResult trace_eye_path(const EyePassInput& input, const CameraRay& camera_ray,
                             const EyeNumbers& numbers, RandomStream& random,
                             InvalidSampleFilter& filter, Arena& arena,
                             const EyePathOutput& output);

/// Follows a camera ray through specular surfaces alone and adds the emitters that they show to
/// `emitters`, one entry a light group, and their luminances to `light` unless null. Returns the
/// rays traced.
std::uint32_t trace_emitter_path(const EyePassInput& input, const CameraRay& camera_ray,
                                 const EyeNumbers& numbers, RandomStream& random,
                                 InvalidSampleFilter& filter, Arena& arena, std::span<Rgb> emitters,
                                 LuminanceByLight* light = nullptr);

}  // namespace aips
