// On which side of a surface a path is.
#pragma once

#include "aips/core/base/vector.h"

namespace aips {

/// The geometric normal of a point, SurfacePoint or VisiblePoint, turned to the side of `wo`.
template <class Point>
Vec3 normal_towards(Vec3 wo, const Point& point) {
    return dot(wo, point.geometric_normal) > 0 ? point.geometric_normal : -point.geometric_normal;
}

}  // namespace aips
