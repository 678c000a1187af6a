// Surfaces met, checked.
#include "refusal/meet_surface.h"

namespace aips {

bool meet_surface(const Scene& scene, Ray& ray, SurfacePoint& point,
                  std::pmr::memory_resource& memory, Refusals& refusals, Sought sought) {
    const bool met = sought == Sought::Smooth ? scene.intersect_smooth(ray, point, memory)
                                              : scene.intersect(ray, point, memory);
    if (point.crossed) ray.medium = point.crossed;
    if (!refusals.accept(point.transmittance, kPassageOrigin)) point.transmittance = {};
    if (!met) return false;
    const bool is_place = is_finite(point.position) && is_finite(point.geometric_normal) &&
                          is_finite(point.shading_normal) && std::isfinite(point.distance);
    if (!is_place) {
        refusals.count(point.material);
        point.bsdf = nullptr;
        point.light = kNoLight;
    }
    const bool lit =
        point.light != kNoLight && refusals.accept(point.emitted, refusals.of_light(point.light));
    if (!lit) point.emitted = {};
    return true;
}

}  // namespace aips
