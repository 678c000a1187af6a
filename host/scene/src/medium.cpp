// Beer-Lambert attenuation.
#include "lxs/scene/medium.h"

#include <cmath>

namespace lxs {

Rgb Medium::transmittance(float distance) const {
    // A channel without absorption stays clear over an infinite distance, where 0 * inf is NaN.
    const auto channel = [&](float absorption) {
        return absorption > 0 ? std::exp(-absorption * distance) : 1.0f;
    };
    return {channel(absorption_.x), channel(absorption_.y), channel(absorption_.z)};
}

}  // namespace lxs
