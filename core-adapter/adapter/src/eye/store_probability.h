// Whether an eye path ends at a surface, as a visible point, or bounces on.
#pragma once

#include <algorithm>
#include <cmath>

#include "aips/adapter/bsdf.h"

namespace aips {

/// Probability of ending where lobes `receiving` take photons and `bouncing` send paths on: by
/// albedo, kept away from 0 and 1 where there are both.
inline float store_probability(const Bsdf& bsdf, Vec3 wo, LobeMask receiving, LobeMask bouncing) {
    if (!receiving) return 0;
    if (!bouncing) return 1;
    const float store = luminance(bsdf.albedo(wo, receiving));
    const float bounce = luminance(bsdf.albedo(wo, bouncing));
    if (!(store + bounce > 0) || !std::isfinite(store + bounce)) return 0.5f;
    return std::clamp(store / (store + bounce), 0.1f, 0.9f);
}

}  // namespace aips
