// Sums in double precision as what image files hold.
#pragma once

#include <algorithm>
#include <limits>

namespace lxs {

/// As a float; what is beyond its range, as its greatest. Images may be brighter than the square
/// root of what a float holds.
inline float finite_float(double value) {
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kMost, kMost));
}

}  // namespace lxs
