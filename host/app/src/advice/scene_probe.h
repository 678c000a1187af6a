// Rays that advice asks the scene with: through the image, straight through everything, all around.
#pragma once

#include <cstdint>
#include <functional>
#include <memory_resource>
#include <optional>
#include <vector>

#include "lxs/host/render_session.h"

namespace lxs {

/// A surface that a ray met; the Bsdf lives as long as the probe.
struct MetSurface {
    Ray ray;
    SurfaceHit hit;
};

/// Numbers in [0, 1), the same in each run.
class ProbeNumbers {
  public:
    explicit ProbeNumbers(std::uint64_t seed) : state_(seed) {}
    float next();
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }

  private:
    std::uint64_t state_;
};

/// What a specular surface does with light: has no lobe that is not specular.
struct SpecularSurface {
    bool reflects = false;
    bool refracts = false;         ///< lets light through and bends it
    bool passes_straight = false;  ///< lets it through as it came: architectural glass, null
};

/// Whether the ray came to the surface from behind.
inline bool from_behind(const Ray& ray, const SurfaceHit& hit) {
    return ray.direction.dot(hit.ng) > 0;
}

/// By a few samples of its Bsdf; nothing for surfaces that are not specular.
SpecularSurface specular_surface(const MetSurface& met);

/// Looks through the image once, on a grid of rays.
class SceneProbe {
  public:
    explicit SceneProbe(const RenderSession& session);
    SceneProbe(const SceneProbe&) = delete;
    SceneProbe& operator=(const SceneProbe&) = delete;

    const Scene& scene() const { return scene_; }
    /// Moment of all rays: the shutter opens.
    float time() const { return time_; }
    /// What the rays through the image met first.
    const std::vector<MetSurface>& seen() const { return seen_; }
    /// Specular surfaces on those rays, also behind others.
    const std::vector<MetSurface>& specular() const { return specular_; }
    const Vec3& eye() const { return eye_; }    ///< mean start of those rays
    const Vec3& view() const { return view_; }  ///< their mean direction, unit

    /// The nearest surface along a ray; nothing if there is none. Its Bsdf lives until the next
    /// call.
    std::optional<MetSurface> meet(const Ray& ray);
    /// Calls `visit` with the surfaces along a ray, one after another, whatever they are, until it
    /// returns false.
    void pass_through(Ray ray, const std::function<bool(const MetSurface&)>& visit);
    /// The one material that all ways from `from` meet first, from behind each time; nothing if
    /// some way meets another, a front, or nothing.
    std::optional<std::uint32_t> solid_around(const Vec3& from);
    /// Whether light that arrived at the surface, and stays on its side, has a free way to the eye.
    bool sees_eye(const MetSurface& from) const;

  private:
    const Scene& scene_;
    float time_;
    std::pmr::monotonic_buffer_resource kept_, passing_;
    std::vector<MetSurface> seen_, specular_;
    Vec3 eye_{0.0f}, view_{0.0f};
};

}  // namespace lxs
