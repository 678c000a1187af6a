// What the engine asks of a host's scene and lights.
#pragma once

#include <cstdint>
#include <limits>
#include <memory_resource>
#include <span>
#include <string>

#include "aips/adapter/bsdf.h"
#include "aips/core/base/bounds.h"
#include "aips/core/sampling/primary_point.h"

namespace aips {

/// A ray in the host's scene; `medium` is the host's own mark of what it travels in.
struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< unit
    float time = 0;  ///< one value per pass, shared by eye and photon paths
    const void* medium = nullptr;
    /// The one component of Rgb that the path still carries, since a surface that disperses light
    /// sent the others elsewhere (the host's Bsdf reads it); kAllComponents for all.
    std::int8_t component = kAllComponents;
};

/// Index of a light in Scene::lights(); kNoLight for none.
using LightIndex = std::uint32_t;
inline constexpr LightIndex kNoLight = std::numeric_limits<LightIndex>::max();

/// Where a ray meets a surface. What follows `bsdf` is the host's: the engine only hands it back.
struct SurfacePoint {
    Vec3 position;
    Vec3 geometric_normal;       ///< unit, the surface's front
    Vec3 shading_normal;         ///< unit, in the geometric normal's hemisphere
    float distance = 0;          ///< along the ray, scene units
    Rgb transmittance{1, 1, 1};  ///< of the medium passed
    Rgb emitted;                 ///< radiance towards the ray's origin
    LightIndex light = kNoLight;
    Rgb medium_emitted;                  ///< radiance of that medium's own that comes to the origin
    LightIndex medium_light = kNoLight;  ///< that this is of
    const Bsdf* bsdf = nullptr;          ///< null: absorbs everything
    std::uint32_t material = 0;          ///< index of a name, for reports
    std::uint32_t object = 0;            ///< likewise, for a film's masks alone
    std::uint32_t primitive = 0;         ///< within the light's shape
    Vec3 position_error;                 ///< rounding error bound per coordinate
    const void* crossed = nullptr;  ///< what the ray was in, if the host knows better than its mark
    const void* interior = nullptr;  ///< mark of a ray that leaves the point behind the surface
    const void* exterior = nullptr;  ///< likewise before it
};

/// A photon as it leaves a light.
struct Emission {
    Ray ray;
    Rgb power;  ///< emitted radiance * cosine / density, watts; not divided by the number of paths
};

/// A direction to a light, as next-event estimation draws it.
struct DirectSample {
    Vec3 wi;             ///< unit, towards the light
    float distance = 0;  ///< infinity for lights at infinity
    Rgb radiance;        ///< unoccluded, along wi; for delta lights irradiance facing wi
    float pdf = 0;       ///< per steradian; 1 for delta lights
    bool delta = false;
    Vec3 segment_end;             ///< where shadow segments end, for the host's Scene::visibility
    std::uint32_t primitive = 0;  ///< within the light's shape, for the host
};

class Light {
  public:
    virtual ~Light() = default;
    /// For reports, beside the light's index: its kind or its name; may be empty.
    virtual std::string name() const { return {}; }
    virtual std::uint32_t group() const = 0;  ///< light group (layer of the film)
    virtual float power() const = 0;          ///< about, in watts; 0 only for a dead light
    virtual bool at_infinity() const = 0;     ///< seen by rays that leave the scene
    /// Whether the camera does not see it, neither straight nor through what passes light straight
    /// on. All else is as without.
    virtual bool hidden_from_camera() const { return false; }
    /// Whether no ray ever meets it: a point, a spot, a parallel beam. All DirectSamples say so
    /// too.
    virtual bool is_delta() const { return false; }
    /// Draws a photon from primary coordinates in [0,1)^4; false if nothing leaves there. They are
    /// finer than single precision tells apart, and rounding to it may give 1: where a light is far
    /// wider than what is seen, places have to be worked out in double precision.
    virtual bool emit(const PrimaryPoint& u, Emission& emission) const = 0;
    /// Draws a direction towards the light from a point.
    virtual bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const = 0;
    /// Density of sample_direct for the direction wi from `from`, which meets the light at `at`
    /// (null for lights at infinity).
    virtual float pdf_direct(const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const = 0;
    /// Primary coordinates in [0,1) from which emit() sends a photon through the position of
    /// `towards`, up to rounding, from the light point that `sample` (of sample_direct from
    /// `towards`) names. Coordinates that the photon does not depend on are left as the caller set
    /// them. False where there are none or the light can't tell; `u` is then undefined. Only
    /// steers sampling: never part of a value.
    virtual bool emission_coordinates(const SurfacePoint& /*towards*/,
                                      const DirectSample& /*sample*/, PrimaryPoint& /*u*/) const {
        return false;
    }
    /// Radiance seen in a direction that leaves the scene; black for other lights.
    virtual Rgb escaped(Vec3 direction) const = 0;
};

class Media;

/// What is known of a scene before any ray is traced.
struct SceneFacts {
    LobeMask lobes = kAllLobes;  ///< every kind that some surface may have
    bool has_media = false;
    /// Most memory that one intersect() takes: of each block its bytes and its alignment less 1, as
    /// it may begin anywhere.
    std::size_t max_bsdf_bytes = 0;
};

/// All const members may be called from many threads.
class Scene {
  public:
    virtual ~Scene() = default;
    /// Nearest surface; its Bsdf is built in `memory` and lives as long as that does. If there is
    /// none, `distance` says how far the ray's medium goes, and `transmittance` and
    /// `medium_emitted` what passes it and comes of it.
    virtual bool intersect(const Ray& ray, SurfacePoint& point,
                           std::pmr::memory_resource& memory) const = 0;
    /// The same for a path that looks for emitters through specular surfaces: where it meets what
    /// is no emitter and has no specular lobe, it may leave all but `distance` and what media do to
    /// light as it is.
    virtual bool intersect_specular(const Ray& ray, SurfacePoint& point,
                                    std::pmr::memory_resource& memory) const {
        return intersect(ray, point, memory);
    }
    /// The same for who asks where a surface is and how it faces: it may leave all but `position`,
    /// `geometric_normal` and `distance` as it is.
    virtual bool intersect_shape(const Ray& ray, SurfacePoint& point,
                                 std::pmr::memory_resource& memory) const {
        return intersect(ray, point, memory);
    }
    /// The ray that leaves `point` along `direction`, free of self-intersection.
    virtual Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const = 0;
    /// Share of light that reaches `point` from the sampled light point; passes straight through
    /// null surfaces and architectural glass, and is dimmed by media.
    virtual Rgb visibility(const SurfacePoint& point, const DirectSample& light,
                           float time) const = 0;
    /// Whether something stands on the straight way between two places that are not on a surface;
    /// what passes light straight on need not count.
    virtual bool blocked(Vec3 from, Vec3 to, float time) const;
    virtual std::span<const Light* const> lights() const = 0;
    virtual std::span<const std::string> material_names() const = 0;
    virtual std::uint32_t light_groups() const = 0;  ///< at least 1
    virtual Bounds bounds() const = 0;               ///< of all surfaces
    virtual SceneFacts facts() const = 0;
    /// Media that scatter light; null if none does, and nothing of it costs anything.
    virtual const Media* media() const { return nullptr; }
};

inline bool Scene::blocked(Vec3 from, Vec3 to, float time) const {
    const Vec3 way = to - from;
    const float distance = length(way);
    if (!(distance > 0)) return false;
    Ray ray;
    ray.origin = from;
    ray.direction = way / distance;
    ray.time = time;
    std::pmr::monotonic_buffer_resource memory;
    SurfacePoint met;
    return intersect_shape(ray, met, memory) && met.distance < distance;
}

/// The ray that carries a path on along `direction`, from a point that `arriving` met. `component`
/// as in BsdfSample.
inline Ray continue_ray(const Scene& scene, const SurfacePoint& point, Vec3 direction,
                        std::int8_t component, const Ray& arriving) {
    Ray ray = scene.spawn(point, direction, arriving.time);
    ray.component = component != kAllComponents ? component : arriving.component;
    return ray;
}

}  // namespace aips
