// Warns of scenes that stand too far from the origin for their size.
#pragma once

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// Extents of the scene (diagonals of its box) from the origin beyond which positions, which are
/// single-precision numbers, are rounded to more than 1/8000 of its extent: shapes, shadows and
/// lights then move by visible amounts.
inline constexpr double kFarthestExtents = 1000;

/// One warning at `where` if a scene with these bounds is farther away than that.
void warn_of_lost_precision(const Bounds& bounds, const SourceLocation& where,
                            Diagnostics& diagnostics);

}  // namespace lxs
