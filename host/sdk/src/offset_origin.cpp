// Robust ray origins: see scene.h.
#include <cmath>

#include "lxs/sdk/scene.h"

namespace lxs {

Vec3 offset_origin(const Vec3& p, const Vec3& p_error, const Vec3& ng, const Vec3& direction) {
    // Pharr, Jakob, Humphreys 2016, section 3.9.5: the error box's extent along the normal.
    const float extent =
        std::abs(ng.x) * p_error.x + std::abs(ng.y) * p_error.y + std::abs(ng.z) * p_error.z;
    const Vec3 offset = ng * (direction.dot(ng) < 0 ? -extent : extent);
    Vec3 origin = p + offset;
    for (int axis = 0; axis < 3; ++axis) {
        // The sum itself is rounded: one float further keeps it outside of the box.
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        if (offset[axis] > 0) origin[axis] = std::nextafter(origin[axis], kInfinity);
        if (offset[axis] < 0) origin[axis] = std::nextafter(origin[axis], -kInfinity);
    }
    return origin;
}

}  // namespace lxs
