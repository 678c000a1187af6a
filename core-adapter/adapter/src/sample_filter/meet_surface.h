// Where a ray meets a surface, with what no surface can be kept out.
#pragma once

#include "aips/adapter/scene.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// Which surfaces matter: all, or emitters and specular ones (Scene::intersect_specular()).
enum class Sought : std::uint8_t { All, Specular };

/// Scene::intersect() for light that counts: a transmittance or an emitted radiance that is not
/// finite or negative is counted against its origin and becomes black; a point without a place or
/// normals that are numbers is counted against its material and absorbs everything. The ray gets
/// the mark of what it was in.
bool meet_surface(const Scene& scene, Ray& ray, SurfacePoint& point,
                  std::pmr::memory_resource& memory, InvalidSampleFilter& filter,
                  Sought sought = Sought::All);

}  // namespace aips
