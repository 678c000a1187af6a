// sRGB's curve of brightness: IEC 61966-2-1.
#pragma once

#include <cmath>

namespace lxs {

/// The linear value that `stored` >= 0 stands for.
inline float linear_of_srgb(float stored) {
    return stored <= 0.04045f ? stored / 12.92f : std::pow((stored + 0.055f) / 1.055f, 2.4f);
}

}  // namespace lxs
