// Surfaces met, checked.
#include "sample_filter/meet_surface.h"

namespace aips {

bool meet_surface(const Scene& scene, Ray& ray, SurfacePoint& point,
                  std::pmr::memory_resource& memory, InvalidSampleFilter& filter, Sought sought) {
    const bool met = sought == Sought::Specular ? scene.intersect_specular(ray, point, memory)
                                                : scene.intersect(ray, point, memory);
    if (point.crossed) ray.medium = point.crossed;
    if (!filter.accept(point.transmittance, kPassageOrigin)) point.transmittance = {};
    if (point.medium_light != kNoLight &&
        !filter.accept(point.medium_emitted, filter.of_light(point.medium_light)))
        point.medium_light = kNoLight;
    if (!met) return false;
    const bool is_place = is_finite(point.position) && is_finite(point.geometric_normal) &&
                          is_finite(point.shading_normal) && std::isfinite(point.distance);
    if (!is_place) {
        filter.count(point.material);
        point.bsdf = nullptr;
        point.light = kNoLight;
    }
    const bool lit =
        point.light != kNoLight && filter.accept(point.emitted, filter.of_light(point.light));
    if (!lit) point.emitted = {};
    return true;
}

}  // namespace aips
