// Where on the lens a camera ray starts.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

/// Uniform over an aperture of radius 1: a disk, or with three blades or more the regular polygon
/// inscribed in it whose first corner lies along +x. `u` in [0, 1)^2; a polygon keeps its
/// stratification within each of its sides' triangles.
Imath::V2d aperture_point(const Vec2& u, int blades);

/// The `u` that gives the aperture's centre.
Vec2 aperture_centre(int blades);

}  // namespace lxs
