// Conversions between the engine's and the host's vocabulary types.
#pragma once

#include <bit>
#include <cstdint>

#include "aips/adapter/layers.h"
#include "aips/adapter/scene.h"
#include "lxs/sdk/layers.h"
#include "lxs/sdk/scene.h"

namespace aips::shim {

inline Vec3 from(const lxs::Vec3& v) {
    return {v.x, v.y, v.z};
}
inline Rgb from(const lxs::Rgb& c) {
    return {c.x, c.y, c.z};
}
inline lxs::Vec3 to(Vec3 v) {
    return {v.x, v.y, v.z};
}
inline lxs::Vec2 to(Vec2 v) {
    return {v.x, v.y};
}
inline lxs::Rgb to(Rgb c) {
    return {c.r, c.g, c.b};
}
inline lxs::Transport to(Transport t) {
    return t == Transport::Radiance ? lxs::Transport::Radiance : lxs::Transport::Power;
}

/// The engine's mark of what a ray is in: the host's list of media. Empty, it is null: vacuum.
inline const void* mark_of(const lxs::EnteredMedia& media) {
    return std::bit_cast<const void*>(media.bits());
}
inline lxs::EnteredMedia media_of(const void* mark) {
    return lxs::EnteredMedia::from_bits(std::bit_cast<std::uint64_t>(mark));
}

inline Ray from(const lxs::Ray& ray) {
    return {from(ray.origin), from(ray.direction), ray.time, mark_of(ray.media), ray.component};
}
inline lxs::Ray to(const Ray& ray) {
    lxs::Ray r;
    r.origin = to(ray.origin);
    r.direction = to(ray.direction);
    r.time = ray.time;
    r.component = ray.component;
    r.media = media_of(ray.medium);
    return r;
}

inline lxs::SeenSurface to(const SeenSurface& seen) {
    return {to(seen.albedo), to(seen.normal), seen.depth, seen.object, seen.material};
}

/// What names the light point of a sample, for the host to take back.
inline lxs::DirectSample to(const DirectSample& sample) {
    lxs::DirectSample s;
    s.wi = to(sample.wi);
    s.distance = sample.distance;
    s.segment_end = to(sample.segment_end);
    s.primitive = sample.primitive;
    return s;
}

/// The part of a hit that the engine hands back to the host.
inline lxs::SurfaceHit to_hit(const SurfacePoint& point) {
    lxs::SurfaceHit hit;
    hit.p = to(point.position);
    hit.p_error = to(point.position_error);
    hit.ng = to(point.geometric_normal);
    hit.interior = media_of(point.interior);
    hit.exterior = media_of(point.exterior);
    return hit;
}

}  // namespace aips::shim
