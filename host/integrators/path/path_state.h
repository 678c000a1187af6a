// A path of PathTracer on its way, and what its parts share.
#pragma once

#include <cmath>

#include "path/path_tracer.h"

namespace lxs {

/// The last vertex at which the path changed direction.
struct PathTracer::Vertex {
    Vec3 p{0.0f};
    Vec3 n{0.0f};   ///< zero in a medium
    float pdf = 0;  ///< of the direction it left with; 0 at the camera and after a specular lobe
    LightTable lights = nullptr;  ///< that shadow rays there chose lights by
};

struct PathTracer::State {
    Ray ray;
    PrimarySample& random;
    PathResult& result;
    Rgb throughput{1.0f};
    Vertex left;
    LightTable lights = nullptr;  ///< of the surface that the path is at
    std::uint32_t bounces = 0;
    std::uint32_t specular = 0;  ///< of these, that do not count for the depth
    aips::EyeScatterings scatterings = {};
    std::uint32_t straight = 0;
    std::uint32_t told_rays = 0;
};

/// The geometric normal on the side that the path comes from: thin walls have two places.
inline Vec3 seen_side(const Ray& ray, const SurfaceHit& hit) {
    return hit.ng.dot(ray.direction) > 0 ? -hit.ng : hit.ng;
}

/// Veach 1997, eq. 9.11 with exponent 2, written so that large densities don't overflow.
inline float power_heuristic(float pdf, float other_pdf) {
    const float ratio = other_pdf / pdf;
    return 1 / (1 + ratio * ratio);
}

}  // namespace lxs
