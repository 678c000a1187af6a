// Extent against distance from the origin.
#include "precision_warning.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lxs {
namespace {

std::string rounded(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

}  // namespace

void warn_of_lost_precision(const Bounds& bounds, const SourceLocation& where,
                            Diagnostics& diagnostics) {
    if (bounds.isEmpty()) return;
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        farthest = std::max(
            {farthest, std::abs(double{bounds.min[axis]}), std::abs(double{bounds.max[axis]})});
    }
    const double extent = (Imath::V3d(bounds.max) - Imath::V3d(bounds.min)).length();
    if (!(extent > 0) || !(farthest > kFarthestExtents * extent)) return;
    diagnostics.warning(
        where, "the scene is " + rounded(extent) + " units wide, but stands " + rounded(farthest) +
                   " units from the origin, where positions are rounded to " +
                   rounded(farthest * 0x1p-23) + " units: move it nearer to the origin");
}

}  // namespace lxs
