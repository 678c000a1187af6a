// Unidirectional path tracing of one camera ray.
//
// References: Kajiya 1986, "The rendering equation"; Veach 1997, "Robust Monte Carlo methods for
// light transport simulation", chapter 9 (multiple importance sampling, power heuristic); Lafortune
// & Willems 1996, "Rendering participating media with bidirectional path tracing" (free flights).
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "aips/core/base/image_part.h"
#include "lxs/sdk/layers.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"
#include "path/light_selector.h"
#include "path/path_sample_filter.h"
#include "path/path_settings.h"
#include "path/primary_sample.h"

namespace lxs {

/// What one path gave.
struct PathResult {
    std::span<Rgb> radiance;  ///< one entry a light group, added to
    std::uint64_t rays = 0;
    std::uint64_t bounces = 0;
    std::span<Rgb> parts = {};    ///< the same by ImagePart; empty: not wanted
    SeenSurface* seen = nullptr;  ///< takes what the path sees of surfaces; null: nothing does
    /// Takes what the first shadow rays from surfaces found, at most kToldRays; null: nothing does.
    std::vector<aips::LightSample>* told = nullptr;
};

/// Shadow rays of a path that tell of lights, if it is one that tells: fewer leave out places that
/// are seen by way of others, more tell of one place after the other from fewer paths. 1, 4 and 16
/// were compared.
inline constexpr std::uint32_t kToldRays = 4;

/// Paths traced and what they took.
struct PathCounts {
    std::uint64_t paths = 0;
    std::uint64_t rays = 0;
    std::uint64_t bounces = 0;

    PathCounts& operator+=(const PathCounts& other);
    void state(StateArchive& archive);
};

/// Estimates the radiance that arrives along a camera ray. Light reaches a path vertex in two ways
/// that share each light path by the power heuristic: next-event estimation, and a scattered ray
/// that meets the light. Both pass straight through null materials and architectural glass, which
/// is no bounce: the scattered ray keeps the density and position of the vertex it left.
class PathTracer {
  public:
    /// Contributions that are not finite or negative are told to `filter`.
    PathTracer(const Scene& scene, const PathSettings& settings, PathSampleFilter& filter);

    void trace(const Ray& camera_ray, PrimarySample& random,
               std::pmr::monotonic_buffer_resource& memory, PathResult& result) const;

    /// The choice of lights, which learns between passes.
    LightSelector& lights() { return lights_; }
    const LightSelector& lights() const { return lights_; }

  private:
    struct Vertex;
    struct State;

    void add(State& state, const Rgb& contribution, const Light& light, aips::ImagePart part) const;
    bool meet(State& state, SurfaceHit& hit, std::pmr::memory_resource& memory) const;
    bool accept_sample(const DirectSample& sample, const Light& light) const;
    /// False for a light that is hidden from the camera, as long as the path has not scattered.
    static bool sees(const State& state, const Light& light);
    void add_emitted(State& state, const SurfaceHit& hit) const;
    void add_emitted_by_medium(State& state, const SurfaceHit& hit) const;
    void add_escaped(State& state) const;
    void add_direct(State& state, const SurfaceHit& hit) const;
    void tell(State& state, const SurfaceHit& hit, const LightChoice& choice, float value) const;
    bool fly(State& state, const Medium& medium, float segment) const;
    bool scatter_in_medium(State& state, const Medium& medium) const;
    void add_direct_in_medium(State& state, const Medium& medium) const;
    Rgb direct_light_in_medium(State& state, const Medium& medium, const LightChoice& choice,
                               const Vec2& u) const;
    Rgb direct_light(State& state, const SurfaceHit& hit, const LightChoice& choice,
                     const Vec2& u) const;
    float light_weight(const State& state, const Light& light, const Vec3& light_p,
                       const Vec3& light_n, std::uint32_t primitive) const;
    bool is_spent(const State& state) const;
    bool scatter(State& state, const SurfaceHit& hit) const;
    bool survives_roulette(State& state) const;

    const Scene& scene_;
    PathSettings settings_;
    LightSelector lights_;
    PathSampleFilter& filter_;
    bool media_scatter_;
};

}  // namespace lxs
