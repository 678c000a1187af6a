// How values that an image stores become linear.
#pragma once

#include <cmath>

namespace lxs {

/// The linear value that `stored` >= 0 stands for by sRGB's curve: IEC 61966-2-1.
inline float linear_of_srgb(float stored) {
    return stored <= 0.04045f ? stored / 12.92f : std::pow((stored + 0.055f) / 1.055f, 2.4f);
}

/// A power or sRGB's curve; as it is, they are linear.
struct StoredCurve {
    float gamma = 1;    ///< each value is raised to it
    bool srgb = false;  ///< by sRGB's curve instead

    bool changes() const { return srgb || gamma != 1; }
    float linear(float stored) const {
        if (srgb) return linear_of_srgb(stored);
        return gamma == 1 ? stored : std::pow(stored, gamma);
    }
};

}  // namespace lxs
