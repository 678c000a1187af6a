// Colours channel by channel.
#pragma once

#include <algorithm>
#include <cmath>

#include "lxs/sdk/types.h"

namespace lxs::shading {

inline Rgb min_of(const Rgb& a, const Rgb& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

/// Scales both down in the channels where they reflect more than arrives.
inline void share_light(Rgb& a, Rgb& b) {
    for (int c = 0; c < 3; ++c) {
        const float sum = a[c] + b[c];
        if (!(sum > 1)) continue;
        a[c] /= sum;
        b[c] /= sum;
    }
}

/// Share of light that a layer of `optical_depth` along its normal leaves over a way of so many
/// times its depth.
inline Rgb absorbed(const Rgb& optical_depth, float way) {
    if (is_black(optical_depth)) return Rgb(1.0f);
    return {std::exp(-optical_depth.x * way), std::exp(-optical_depth.y * way),
            std::exp(-optical_depth.z * way)};
}

}  // namespace lxs::shading
