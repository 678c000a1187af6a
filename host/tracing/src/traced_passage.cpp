// What of light passes along a ray through the traced scene: media, and surfaces that let it pass
// straight.
#include <cmath>
#include <limits>

#include "scene_sphere.h"
#include "surface_point.h"
#include "traced_scene.h"

namespace lxs {

Rgb TracedScene::transmittance(const Ray& ray) const {
    if (survey_.has_straight) {
        const bool blocked =
            device_.distinguishes_classes() && world_scene_.occluded(ray, SurfaceClass::Opaque);
        return blocked ? Rgb(0.0f) : walk_transmittance(ray);
    }
    // Light that passes no surface stays in the ray's medium: any hit at all decides.
    if (world_scene_.occluded(ray, SurfaceClass::Any)) return Rgb(0.0f);
    return medium_transmittance(ray, medium(ray.media), 0, ray.t_max);
}

/// Of the part [from, to] of a ray, which lies in `medium`; an endless one ends with the scene.
Rgb TracedScene::medium_transmittance(const Ray& ray, const Medium* medium, float from,
                                      float to) const {
    if (!medium) return Rgb(1.0f);
    if (!std::isfinite(to)) to = distance_to_end(sphere_, ray);
    return medium->transmittance(ray.origin + ray.direction * from, ray.direction,
                                 std::max(to - from, 0.0f));
}

// Goes from surface to surface on the same ray, whose start moves past each hit by one rounding
// step: origin and direction stay, so the kernel computes the same distance for a surface that was
// passed and leaves it out, and the segment's end doesn't drift.
Rgb TracedScene::walk_transmittance(const Ray& ray) const {
    Rgb share(1.0f);
    Ray passing = ray;  // in the media that it is in beyond what it has passed
    float start = kSmallestDistance, passed = 0;
    for (int i = 0; i < kMaxStraightSurfaces; ++i) {
        RawHit raw;
        if (!world_scene_.intersect(ray, start, SurfaceClass::Straight, raw))
            return share * medium_transmittance(ray, medium(passing.media), passed, ray.t_max);
        const Placement& placement = placement_of(raw);
        const Surface& surface = placement.surfaces[raw.geometry];
        if (!surface.straight) return Rgb(0.0f);
        SurfaceHit hit;
        ShadingPoint point;
        locate_hit(passing, raw, hit, point);
        share *= medium_transmittance(ray, medium(hit.crossed), passed, raw.distance) *
                 surface.material->straight_transmittance(point, ray.direction);
        if (is_black(share)) return share;
        passing.media = ray.direction.dot(hit.ng) > 0 ? hit.exterior : hit.interior;
        passed = raw.distance;
        start = std::nextafter(raw.distance, std::numeric_limits<float>::infinity());
    }
    return Rgb(0.0f);
}

}  // namespace lxs
