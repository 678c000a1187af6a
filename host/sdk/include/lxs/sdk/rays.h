// Rays that leave a surface: robust origins, the right medium, shadow rays that stop at the light.
#pragma once

#include "lxs/sdk/light.h"
#include "lxs/sdk/scene.h"

namespace lxs {

/// The ray from a hit along `direction`, in the medium on that side of the surface.
inline Ray spawn_ray(const SurfaceHit& hit, const Vec3& direction, float time) {
    Ray ray;
    ray.origin = offset_origin(hit.p, hit.p_error, hit.ng, direction);
    ray.direction = direction;
    ray.time = time;
    ray.medium = direction.dot(hit.ng) > 0 ? hit.exterior : hit.interior;
    return ray;
}

/// The segment from a hit to a sampled light point that stops short of the light's own surface:
/// by the bound of the light point's rounding error and 1e-5 of the distance, so that it depends
/// on no scale and a light is not shadowed by itself.
inline Ray shadow_ray(const SurfaceHit& hit, const DirectSample& light, float time) {
    Ray ray = spawn_ray(hit, light.wi, time);
    if (std::isfinite(light.distance)) {
        const Vec3 target = hit.p + light.wi * light.distance;
        const Vec3& e = light.light_error;
        const float length = (target - ray.origin).dot(light.wi);
        ray.t_max = std::max(0.0f, length * (1 - 1e-5f) - 2 * (e.x + e.y + e.z));
    }
    return ray;
}

}  // namespace lxs
