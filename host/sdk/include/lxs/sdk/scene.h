// The scene as integrators see it.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <string>
#include <vector>

#include "lxs/sdk/bsdf.h"
#include "lxs/sdk/light.h"
#include "lxs/sdk/types.h"

namespace lxs {

class Medium;

/// Where a ray meets a surface.
struct SurfaceHit {
    Vec3 p{0.0f};                  ///< position, world space
    Vec3 p_error{0.0f};            ///< bound of p's rounding error per coordinate, tracing included
    Vec3 ng{0.0f};                 ///< geometric normal, unit, the surface's own (front) side
    Vec3 ns{0.0f};                 ///< shading normal, unit, in the hemisphere of ng
    Vec2 uv{0.0f};                 ///< texture coordinates, where the surface's looks need them
    Vec3 dpdu{0.0f};               ///< tangent along u, likewise; zero when unknown
    float distance = 0;            ///< along the ray
    Rgb transmittance{1.0f};       ///< of that medium over `distance`
    const Bsdf* bsdf = nullptr;    ///< null: scatters nothing
    const Light* light = nullptr;  ///< emissive surface's light, else null
    Rgb emitted{0.0f};             ///< radiance it sends towards the ray's origin
    Rgb medium_emitted{0.0f};  ///< radiance of the medium's own that comes to it over `distance`
    const Light* medium_light = nullptr;  ///< that this is of; null if the medium does not emit
    EnteredMedia crossed = {};    ///< what the ray travelled in, which the surface may know better
    EnteredMedia interior = {};   ///< what a ray that leaves the hit behind the surface (-ng) is in
    EnteredMedia exterior = {};   ///< likewise before it (+ng)
    std::uint32_t primitive = 0;  ///< triangle within the light's shape (Light::pdf_direct)
    std::uint32_t material = 0;   ///< index into Scene::material_names()
    std::uint32_t object = 0;     ///< index into Scene::object_names()
};

/// Facts about a scene that let an integrator leave out what the scene doesn't need.
struct SceneFacts {
    bool has_diffuse = false;           ///< some surface has a diffuse lobe
    bool has_glossy = false;            ///< some surface has a glossy lobe
    bool has_specular = false;          ///< some surface has a specular lobe
    bool has_transmission = false;      ///< some surface lets light through
    bool has_media = false;             ///< some medium dims or emits light
    bool has_scattering_media = false;  ///< some medium scatters, and that is to be rendered
    bool has_motion = false;
    bool disperses = false;  ///< some surface bends each wavelength its own way
    bool has_image_textures = false;
    std::size_t triangles = 0;
    std::size_t quadrics = 0;  ///< spheres, disks, cones and the like, which are no triangles
    /// Most memory that one `intersect` takes from its resource: of each block its bytes and its
    /// alignment less 1.
    std::size_t max_bsdf_bytes = 0;
};

/// A loaded scene. All const members may be called from many threads at once.
class Scene {
  public:
    virtual ~Scene() = default;

    /// Nearest surface along `ray`; builds its Bsdf in `memory` (see Bsdf for lifetime). If there
    /// is none, `distance` says how far the ray's medium goes, up to the end of the scene, and
    /// `transmittance` and `medium_emitted` what of light passes it and comes of it.
    virtual bool intersect(const Ray& ray, SurfaceHit& hit,
                           std::pmr::memory_resource& memory) const = 0;
    /// The same for a path that looks for emitters through specular surfaces: where it meets what
    /// is no emitter and has no specular lobe, all but `distance` and what media do to light may be
    /// left out.
    virtual bool intersect_specular(const Ray& ray, SurfaceHit& hit,
                                    std::pmr::memory_resource& memory) const {
        return intersect(ray, hit, memory);
    }
    /// The same for who asks where a surface is and how it faces: all but `p`, `ng` and `distance`
    /// may be left out.
    virtual bool intersect_shape(const Ray& ray, SurfaceHit& hit,
                                 std::pmr::memory_resource& memory) const {
        return intersect(ray, hit, memory);
    }
    /// Share of light that arrives over the segment from `ray.origin` to `ray.t_max`, which the
    /// caller has shortened to stop before the light: 0 when blocked. Null materials and
    /// architectural glass let it pass undeviated; media absorb.
    virtual Rgb transmittance(const Ray& ray) const = 0;
    /// The medium in which a ray within these media travels; null for vacuum.
    virtual const Medium* medium(const EnteredMedia& media) const = 0;

    virtual std::span<const Light* const> lights() const = 0;
    /// Names of the light groups, by index; at least one ("default").
    virtual std::span<const std::string> light_groups() const = 0;
    virtual std::span<const std::string> material_names() const = 0;
    /// Of what masks tell apart; none: there are no such masks.
    virtual std::span<const std::string> object_names() const { return {}; }
    /// Box around all surfaces, lights at infinity left out; empty for an empty scene.
    virtual Bounds bounds() const = 0;
    virtual SceneFacts facts() const = 0;
};

}  // namespace lxs
