// Whether a guide of photons can pay in a scene, found out before its first pass.
//
// A guide sends photons where the image sees them. Where most are seen anyway there is nothing to
// gain, and what learning costs, and photons that count for less while it learns, would be lost.
#pragma once

#include "aips/adapter/settings.h"
#include "eye_pass.h"

namespace aips {

/// Share of unguided photon paths that are seen from which on photons go without the adaptive guide
/// (docs/adaptive-guide.md).
inline constexpr double kSeenWithoutGuide = 1.0 / 3;

/// Share of unguided photon paths that land within `radius` (scene units, > 0) of a visible point
/// of `image`, or a cell's width beyond, in [0, 1]. The paths have numbers of their own and bring
/// nothing into the image, whose expectation therefore does not depend on what is made of the
/// share.
double seen_share(const Scene& scene, const Settings& settings, float time, const EyeImage& image,
                  float radius);

}  // namespace aips
