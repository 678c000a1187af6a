// The box that a tree over a scene starts from.
#pragma once

#include "aips/core/base/bounds.h"

namespace aips {

/// The scene's box; an empty or infinite one counts as the origin.
inline Bounds usable_bounds(const Bounds& box) {
    const bool usable = !box.empty() && is_finite(box.lower) && is_finite(box.upper);
    return usable ? box : Bounds{{0, 0, 0}, {0, 0, 0}};
}

/// Plane that halves the box. Between neighbouring floats, where there is none, the upper one: the
/// lower would leave a leaf as it was, and be split again without end.
inline float halving_plane(const Bounds& box, int axis) {
    const float half = 0.5f * box.lower[axis] + 0.5f * box.upper[axis];
    return half > box.lower[axis] ? half : box.upper[axis];
}

}  // namespace aips
