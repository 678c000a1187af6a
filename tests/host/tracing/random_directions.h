// Random directions for tests, the same with every standard library.
#pragma once

#include <cmath>
#include <random>

#include "lxs/sdk/types.h"

namespace lxs::test {

using Random = std::mt19937;

inline float uniform(Random& random, float low, float high) {
    // Not std::uniform_real_distribution: its stream differs between libraries.
    return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
}

/// Uniform over the unit sphere.
inline Vec3 random_direction(Random& random) {
    const float z = uniform(random, -1, 1);
    const float phi = uniform(random, 0, 6.2831853f);
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

}  // namespace lxs::test
