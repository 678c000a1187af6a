// Rays that leave a surface: robust origins, the right medium, shadow rays that stop at the light.
#pragma once

#include <cmath>

#include "lxs/sdk/light.h"
#include "lxs/sdk/offset_origin.h"
#include "lxs/sdk/scene.h"

namespace lxs {

/// The ray from a hit along `direction`, in the media on that side of the surface.
inline Ray spawn_ray(const SurfaceHit& hit, const Vec3& direction, float time) {
    Ray ray;
    ray.origin = offset_origin(hit.p, hit.p_error, hit.ng, direction);
    ray.direction = direction;
    ray.time = time;
    ray.media = direction.dot(hit.ng) > 0 ? hit.exterior : hit.interior;
    return ray;
}

/// The ray that carries a path on as `sample` says, from a hit that `arriving` met.
inline Ray continue_ray(const SurfaceHit& hit, const BsdfSample& sample, const Ray& arriving) {
    Ray ray = spawn_ray(hit, sample.wi, arriving.time);
    ray.component = sample.component != kAllComponents ? sample.component : arriving.component;
    return ray;
}

/// The segment from a hit to a sampled light point. Both ends stand off their surfaces by the
/// bounds of rounding, along the normals, so that neither surface shadows itself at any scale or
/// angle.
inline Ray shadow_ray(const SurfaceHit& hit, const DirectSample& light, float time) {
    Ray ray = spawn_ray(hit, light.wi, time);
    if (!std::isfinite(light.distance)) return ray;
    const Vec3 to_end = light.segment_end - ray.origin;
    ray.t_max = to_end.length();
    if (ray.t_max > 0) ray.direction = to_end / ray.t_max;
    return ray;
}

/// The ray that leaves a point within `media` along `direction`.
inline Ray ray_from_medium(const Vec3& p, const Vec3& direction, float time,
                           const EnteredMedia& media) {
    Ray ray;
    ray.origin = p;
    ray.direction = direction;
    ray.time = time;
    ray.media = media;
    return ray;
}

/// The segment from a point within `media` to a sampled light point.
inline Ray shadow_ray_from_medium(const Vec3& p, const DirectSample& light, float time,
                                  const EnteredMedia& media) {
    Ray ray = ray_from_medium(p, light.wi, time, media);
    if (!std::isfinite(light.distance)) return ray;
    const Vec3 to_end = light.segment_end - p;
    ray.t_max = to_end.length();
    if (ray.t_max > 0) ray.direction = to_end / ray.t_max;
    return ray;
}

}  // namespace lxs
