// Subdivision of triangle meshes.
#pragma once

#include "lxs/scene/geometry.h"

namespace lxs {

struct SubdivisionRules {
    bool smooth = true;           ///< Loop's rules; else triangles are only split
    bool sharp_boundary = false;  ///< boundaries are split, not smoothed
    bool merge = true;            ///< vertices at one place are one, whatever else they carry
};

/// Splits each triangle into four, `levels` times. Positions follow Loop's rules (Loop 1987,
/// "Smooth subdivision surfaces based on triangles", with Warren's weights), at last moved to the
/// limit surface, whose normals they get (Hoppe et al. 1994, "Piecewise smooth surface
/// reconstruction", section 3); coordinates, colours and opacities are interpolated. Without
/// `smooth`, all are, and normals too.
TriangleMesh subdivide(const TriangleMesh& mesh, int levels, const SubdivisionRules& rules);

/// Per vertex, the index of the first one at the same place.
std::vector<std::uint32_t> places_of(const std::vector<Vec3>& positions);

}  // namespace lxs
