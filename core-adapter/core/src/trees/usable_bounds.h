// The box that a tree over a scene starts from.
#pragma once

#include "aips/core/base/bounds.h"

namespace aips {

/// The scene's box; an empty or infinite one counts as the origin.
inline Bounds usable_bounds(const Bounds& box) {
    const bool usable = !box.empty() && is_finite(box.lower) && is_finite(box.upper);
    return usable ? box : Bounds{{0, 0, 0}, {0, 0, 0}};
}

}  // namespace aips
