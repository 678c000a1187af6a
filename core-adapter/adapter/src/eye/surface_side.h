// On which side of a surface a path is.
#pragma once

#include "aips/adapter/scene.h"

namespace aips {

/// The geometric normal of `point`, turned to the side of `wo`.
inline Vec3 normal_towards(Vec3 wo, const SurfacePoint& point) {
    return dot(wo, point.geometric_normal) > 0 ? point.geometric_normal : -point.geometric_normal;
}

}  // namespace aips
