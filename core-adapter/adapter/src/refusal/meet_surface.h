// Where a ray meets a surface, with what no surface can be kept out.
#pragma once

#include "aips/adapter/scene.h"
#include "refusal/refusals.h"

namespace aips {

/// Which surfaces matter: all, or lamps and smooth ones (Scene::intersect_smooth()).
enum class Sought : std::uint8_t { All, Smooth };

/// Scene::intersect() for light that counts: a transmittance or an emitted radiance that is not
/// finite or negative is counted against its origin and becomes black; a point without a place or
/// normals that are numbers is counted against its material and absorbs everything. The ray gets
/// the mark of what it was in.
bool meet_surface(const Scene& scene, Ray& ray, SurfacePoint& point,
                  std::pmr::memory_resource& memory, Refusals& refusals,
                  Sought sought = Sought::All);

}  // namespace aips
