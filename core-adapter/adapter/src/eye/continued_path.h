// An eye path that goes on from its visible point, for light that photons could bring there too, or
// sends one BSDF-sampled ray alone, for direct light.
#pragma once

#include "aips/core/sampling/eye_numbers.h"
#include "eye/path_tip.h"
#include "views/light_target.h"

namespace aips {

/// From where and how.
struct ContinuedStart {
    const SurfacePoint& point;  ///< the visible point's surface
    Vec3 wo;
    LobeMask receiving = 0;   ///< lobes that take photons there
    std::uint32_t depth = 0;  ///< its number along the eye path
    float choice_pdf = 1;     ///< probability that the path ended there, and did not bounce on
    PathTip tip;  ///< at the visible point, its throughput divided by all choices' probabilities
    LightIndex asked = kNoLight;  ///< by the shadow ray from there
    bool bsdf_direct = false;     ///< ends where it is turned away from its first direction
};

/// What a path did.
struct ContinuedResult {
    std::uint32_t rays = 0;  ///< traced
    float straight = 0;      ///< luminance of lights that its BSDF-sampled ray met
    float of_asked = 0;      ///< of ContinuedStart::asked among them
};

/// Where its light goes.
struct ContinuedOutput {
    LightSums direct;
    std::span<Rgb> continued;           ///< [light group]; all of it indirect
    LuminanceByLight* light = nullptr;  ///< takes luminances by light; null: not asked for
    float share = 0;                    ///< of `continued` that counts in these
};

/// Follows the path and adds to `continued` (one entry a light group) what photons could bring as
/// well: light that reached the first surface it was turned away by straight from an emitter, and
/// left it diffusely or glossily. Light that specular surfaces focus on that surface is the
/// photons' alone. The path goes as deep as photons do. Lights that its BSDF-sampled ray meets are
/// added to `direct`.
ContinuedResult trace_continued_path(const EyePassInput& input, const ContinuedStart& start,
                                     const EyeNumbers& numbers, InvalidSampleFilter& filter,
                                     Arena& arena, const ContinuedOutput& output);

}  // namespace aips
