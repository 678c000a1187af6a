// Conversions between the engine's vocabulary types and the plain ones of LuxRender's half.
#pragma once

#include "aips/adapter/scene.h"
#include "lux_view.h"

namespace aips::luxrender {

inline Vec3 vector_of(const Triple& t) {
    return {t.v[0], t.v[1], t.v[2]};
}
inline Rgb rgb_of(const Triple& t) {
    return {t.v[0], t.v[1], t.v[2]};
}
inline Triple to(Vec3 v) {
    return {{v.x, v.y, v.z}};
}
inline Triple to(Rgb c) {
    return {{c.r, c.g, c.b}};
}
inline Ray ray_of(const ViewRay& ray) {
    return {vector_of(ray.origin), vector_of(ray.direction), ray.time, ray.volume,
            static_cast<std::int8_t>(ray.component)};
}
inline ViewRay to(const Ray& ray) {
    return {to(ray.origin), to(ray.direction), ray.time, ray.medium, ray.component};
}

}  // namespace aips::luxrender
