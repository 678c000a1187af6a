// Colours channel by channel.
#pragma once

#include <algorithm>
#include <cmath>

#include "lxs/sdk/types.h"

namespace lxs::shading {

inline Rgb min_of(const Rgb& a, const Rgb& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

/// Share of light that a layer of `optical_depth` along its normal leaves over a way of so many
/// times its depth.
inline Rgb absorbed(const Rgb& optical_depth, float way) {
    if (is_black(optical_depth)) return Rgb(1.0f);
    return {std::exp(-optical_depth.x * way), std::exp(-optical_depth.y * way),
            std::exp(-optical_depth.z * way)};
}

}  // namespace lxs::shading
