// What the normals of a surface tell: on which side a path is, and how light that arrives counts.
#pragma once

#include <algorithm>

#include "aips/core/base/vector.h"
#include "eye/constants.h"

namespace aips {

/// The geometric normal of a point, SurfacePoint or VisiblePoint, turned to the side of `wo`.
template <class Point>
Vec3 normal_towards(Vec3 wo, const Point& point) {
    return dot(wo, point.geometric_normal) > 0 ? point.geometric_normal : -point.geometric_normal;
}

/// Ratio of the cosine that a Bsdf wants (shading normal) to the one that the density of photons
/// has (geometric normal), of a photon that comes from `wi` to a SurfacePoint or VisiblePoint;
/// 0 where the light comes along the surface.
///
/// Departure from Veach (1997, section 5.3.2): at most kMostNormalRatio. Without a bound its square
/// has no mean, and one photon in millions blots an image. Of the light that arrives evenly from
/// everywhere, a surface loses (wi.ns)^2 / kMostNormalRatio, with wi along it, at most 1 %.
template <class Point>
float normal_ratio(const Point& point, Vec3 wi) {
    if (point.shading_normal == point.geometric_normal) return 1;
    const float geometric = abs_dot(wi, point.geometric_normal);
    if (!(geometric > 0)) return 0;
    return std::min(abs_dot(wi, point.shading_normal) / geometric, kMostNormalRatio);
}

}  // namespace aips
