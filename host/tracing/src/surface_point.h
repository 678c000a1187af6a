// Points of surfaces, reconstructed accurately from what the ray-tracing kernel reports.
#pragma once

#include "embree_scene.h"
#include "lxs/scene/texture.h"
#include "lxs/sdk/scene.h"
#include "placement.h"
#include "surface.h"

namespace lxs {

/// Writes the geometric members of `hit` (p, p_error, ng, ns, uv, dpdu) for a hit on `surface`.
/// `instance` is null for surfaces that stand in the world. `raw` gets better weights where the
/// kernel's are of no use.
void locate(const Surface& surface, const InstanceTransform* instance, const Ray& ray, RawHit& raw,
            SurfaceHit& hit);

/// Tangent along v at a located hit; zero where the surface has no coordinates. Kept apart from
/// locate(), since only bumped surfaces need it.
Vec3 tangent_along_v(const Surface& surface, const InstanceTransform* instance, const RawHit& raw,
                     const SurfaceHit& hit);
/// Writes what the mesh's vertices carry for textures (color, alpha), if they do.
void add_vertex_values(const Surface& surface, const RawHit& raw, TexturePoint& point);

}  // namespace lxs
