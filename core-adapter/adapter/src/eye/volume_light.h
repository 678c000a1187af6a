// Single scattering in a medium: what a light sends straight onto an eye path's segment there.
#pragma once

#include "aips/core/sampling/eye_numbers.h"
#include "base/luminance_by_light.h"
#include "eye/direct_light.h"
#include "eye/volume_beam.h"
#include "views/light_target.h"

namespace aips {

/// Where light that media scatter goes.
struct ScatteredLightOutput {
    LightTarget radiance;
    LuminanceByLight* light = nullptr;  ///< takes luminances by light; null: not asked for
};

/// Adds next-event estimation at one point of the segment to `output`.
/// The point is drawn by transmittance or by the angle it is seen at from the light (Kulla and
/// Fajardo 2012, "Importance sampling techniques for path tracing in participating media", section
/// 3), weighed by the balance heuristic. Returns shadow rays traced.
unsigned estimate_scattered_light(const Scene& scene, const DirectLight& lights,
                                  const VolumeBeam& beam, float time, const SegmentNumbers& u,
                                  InvalidSampleFilter& filter, const ScatteredLightOutput& output);

}  // namespace aips
