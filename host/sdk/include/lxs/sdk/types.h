// Vocabulary types of the host: Imath vectors, linear RGB colours, rays.
#pragma once

#include <Imath/ImathBox.h>
#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <cstdint>
#include <limits>

#include "lxs/sdk/entered_media.h"

namespace lxs {

using Vec2 = Imath::V2f;
using Vec3 = Imath::V3f;
using Bounds = Imath::Box3f;
/// Row vectors times matrix (Imath): translation in row 3, the order in which scene files list it.
using Matrix = Imath::M44d;
/// Linear RGB, Rec. 709 primaries; radiance in W sr^-1 m^-2 up to the scene's own scale.
using Rgb = Imath::C3f;

/// Ray::component of a path that has not been dispersed.
inline constexpr std::int8_t kAllComponents = -1;

/// A ray or, with a finite `t_max`, a segment. `direction` has unit length.
struct Ray {
    Vec3 origin{0.0f};
    Vec3 direction{0.0f, 0.0f, 1.0f};
    float t_max = std::numeric_limits<float>::infinity();
    float time = 0;           ///< in shutter units of the scene file
    EnteredMedia media = {};  ///< that the ray is in (Scene::medium)
    /// The one component of an Rgb that the path still carries, since a surface that disperses
    /// light sent the others elsewhere; kAllComponents for all.
    std::int8_t component = kAllComponents;
};

inline float luminance(const Rgb& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
inline float max_component(const Rgb& c) {
    return std::max(c.x, std::max(c.y, c.z));
}
inline bool is_black(const Rgb& c) {
    return c.x == 0 && c.y == 0 && c.z == 0;
}

}  // namespace lxs
