// Beer-Lambert attenuation.
#include "lxs/scene/medium.h"

#include <cmath>

namespace lxs {

Rgb Medium::transmittance(float distance, const Wavelengths* wavelengths) const {
    const Rgb absorption = wavelengths ? wavelengths->intensity(absorption_) : absorption_;
    // A channel without absorption stays clear over an infinite distance, where 0 * inf is NaN.
    const auto channel = [&](float coefficient) {
        return coefficient > 0 ? std::exp(-coefficient * distance) : 1.0f;
    };
    return {channel(absorption.x), channel(absorption.y), channel(absorption.z)};
}

}  // namespace lxs
