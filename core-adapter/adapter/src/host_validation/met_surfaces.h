// Surfaces that rays meet on their way through a scene: they are checked on the way, and a few
// places of each material are kept.
#pragma once

#include <map>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "emit_at_random.h"
#include "findings.h"

namespace aips {

/// Streams of random numbers of the parts of a check.
enum class CheckStream : std::uint64_t { Rays, Materials, Lights = 1u << 20 };

inline RandomStream check_stream(const HostValidationSettings& settings, CheckStream part,
                                 std::uint64_t index) {
    return {settings.seed, std::uint64_t(part), index, RandomDomain::Guide};
}

/// Shoots rays from the lights and from places within the scene, and follows them over bounces.
class MetSurfaces {
  public:
    MetSurfaces(const Scene& scene, const HostValidationSettings& settings, HostFindings& findings);

    /// Rays that meet a material, at most as many as settings.places from each side.
    struct Places {
        std::vector<Ray> front, back;
        std::uint64_t met_front = 0, met_back = 0;
    };
    const std::map<std::uint32_t, Places>& materials() const { return materials_; }
    /// Whether places and normals are sound: all else rests on them.
    bool sound() const { return sound_; }
    /// Rays that meet any surface, some hundred of them.
    const std::vector<Ray>& anywhere() const { return anywhere_; }

  private:
    void shoot();
    void follow(Ray ray, LightIndex from);
    bool same_surface(const SurfacePoint& a, const SurfacePoint& b) const;
    bool behind_light(const Ray& ray, const SurfacePoint& met, LightIndex from) const;
    void look_at(const Ray& ray, const SurfacePoint& point, std::size_t bytes);
    void look_at_normals(const SurfacePoint& point);
    void look_at_place(const Ray& ray, const SurfacePoint& point);
    void keep(const Ray& ray, const SurfacePoint& point);
    void keep(const Ray& ray, std::vector<Ray>& rays, std::uint64_t& met);
    void report(HostFindings& findings);

    const Scene& scene_;
    const HostValidationSettings& settings_;
    RandomStream random_;
    SceneFacts facts_;
    float coarseness_;  // rounding of positions, scene units
    std::map<std::uint32_t, Places> materials_;
    std::vector<Ray> anywhere_;
    std::uint64_t met_ = 0;
    CheckStatistics memory_, lobes_, normals_, hemispheres_, positions_, values_, indices_,
        spawned_, bounds_;
    CheckStatistics emitted_starts_;
    bool sound_ = true;
};

}  // namespace aips
