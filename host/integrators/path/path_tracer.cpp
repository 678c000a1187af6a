// Unidirectional path tracing of one camera ray.
#include "path/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lxs/sdk/medium.h"
#include "lxs/sdk/rays.h"
#include "path/path_state.h"
#include "path/surface_view.h"

namespace lxs {
namespace {

/// Bounces before Russian roulette begins: LuxRender's number.
constexpr std::uint32_t kRouletteStart = 3;
/// A ray caught between surfaces that let it pass straight must end some day.
constexpr std::uint32_t kMaxStraight = 1000;
constexpr LobeMask kScattering = kDiffuse | kGlossy;

}  // namespace

PathCounts& PathCounts::operator+=(const PathCounts& other) {
    paths += other.paths;
    rays += other.rays;
    bounces += other.bounces;
    return *this;
}

void PathCounts::state(StateArchive& archive) {
    for (std::uint64_t* count : {&paths, &rays, &bounces})
        archive.value(*count);
}

PathTracer::PathTracer(const Scene& scene, const PathSettings& settings, PathSampleFilter& filter)
    : scene_(scene),
      settings_(settings),
      lights_(scene.lights(), settings.lights, scene.bounds()),
      filter_(filter),
      media_scatter_(scene.facts().has_scattering_media) {}

void PathTracer::trace(const Ray& camera_ray, PrimarySample& random,
                       std::pmr::monotonic_buffer_resource& memory, PathResult& result) const {
    State state{.ray = camera_ray, .random = random, .result = result, .left = {}};
    SurfaceView view(result.seen);
    for (;;) {
        memory.release();
        SurfaceHit hit;
        ++result.rays;
        const bool met = meet(state, hit, memory);
        if (hit.medium_light) add_emitted_by_medium(state, hit);
        state.ray.media = hit.crossed;
        const Medium* const medium = media_scatter_ ? scene_.medium(hit.crossed) : nullptr;
        if (medium && medium->scatters()) {
            if (fly(state, *medium, hit.distance)) {
                if (!scatter_in_medium(state, *medium)) break;
                view.scattered();
                continue;
            }
        } else {
            state.throughput *= hit.transmittance;
        }
        if (!met) {
            add_escaped(state);
            break;
        }
        if (view.wanted()) view.meet(hit, state.ray.direction, state.throughput);
        add_emitted(state, hit);
        if (hit.bsdf == nullptr) break;
        if (!is_spent(state)) add_direct(state, hit);
        if (!scatter(state, hit)) break;
        if (view.wanted()) view.leave(state.ray.direction, state.throughput);
    }
    result.bounces += state.bounces;
}

/// Where the ray meets a surface. What no surface can be absorbs, what no light can be is black.
bool PathTracer::meet(State& state, SurfaceHit& hit, std::pmr::memory_resource& memory) const {
    const bool met = scene_.intersect(state.ray, hit, memory);
    if (!filter_.accept_of_passage(valid(hit.transmittance))) hit.transmittance = Rgb(0.0f);
    if (hit.medium_light && !filter_.accept_of_light(valid(hit.medium_emitted), *hit.medium_light))
        hit.medium_light = nullptr;
    if (!met) return false;
    const bool is_place =
        finite(hit.p) && finite(hit.ng) && finite(hit.ns) && std::isfinite(hit.distance);
    if (!filter_.accept_of_material(is_place, hit.material)) {
        hit.bsdf = nullptr;
        hit.light = nullptr;
    }
    if (hit.light && !filter_.accept_of_light(valid(hit.emitted), *hit.light)) hit.light = nullptr;
    return true;
}

void PathTracer::add(State& state, const Rgb& contribution, const Light& light,
                     aips::ImagePart part) const {
    Rgb& sum = state.result.radiance[light.group()];
    const Rgb raised = sum + contribution;
    if (!filter_.accept_of_light(valid(contribution) && valid(raised), light)) return;
    sum = raised;
    if (!state.result.parts.empty())
        state.result.parts[static_cast<std::size_t>(part)] += contribution;
}

bool PathTracer::accept_sample(const DirectSample& sample, const Light& light) const {
    const bool usable = valid(sample.radiance) && valid_density(sample.pdf) && finite(sample.wi);
    return filter_.accept_of_light(usable, light);
}

/// Share of a light met by a scattered ray that next-event estimation leaves to it.
float PathTracer::light_weight(const State& state, const Light& light, const Vec3& light_p,
                               const Vec3& light_n, std::uint32_t primitive) const {
    if (!settings_.direct_light_sampling || state.left.pdf == 0) return 1;
    const float pdf = light.pdf_direct(state.left.p, state.left.n, state.ray.direction, light_p,
                                       light_n, primitive);
    // No density: what it weighs is refused, and counted against the light.
    if (!(pdf >= 0)) return std::numeric_limits<float>::quiet_NaN();
    return power_heuristic(state.left.pdf, pdf * lights_.probability(&light, state.left.lights));
}

bool PathTracer::sees(const State& state, const Light& light) {
    return state.bounces > 0 || !light.hidden_from_camera();
}

void PathTracer::add_emitted(State& state, const SurfaceHit& hit) const {
    if (hit.light == nullptr || is_black(hit.emitted) || !sees(state, *hit.light)) return;
    const float weight = light_weight(state, *hit.light, hit.p, hit.ng, hit.primitive);
    add(state, state.throughput * hit.emitted * weight, *hit.light, state.scatterings.met());
}

/// Of the medium that the ray crosses.
void PathTracer::add_emitted_by_medium(State& state, const SurfaceHit& hit) const {
    const float weight = light_weight(state, *hit.medium_light, Vec3(0.0f), Vec3(0.0f), 0);
    add(state, state.throughput * hit.medium_emitted * weight, *hit.medium_light,
        state.scatterings.met());
}

void PathTracer::add_escaped(State& state) const {
    if (lights_.at_infinity().empty()) return;
    if (state.bounces == 0 && !settings_.include_environment) return;
    const Vec3& direction = state.ray.direction;
    for (const Light* light : lights_.at_infinity()) {
        if (!sees(state, *light)) continue;
        const Rgb radiance = light->escaped(direction);
        if (is_black(radiance) || !filter_.accept_of_light(valid(radiance), *light)) continue;
        const float weight = light_weight(state, *light, Vec3(0.0f), Vec3(0.0f), 0);
        add(state, state.throughput * radiance * weight, *light, state.scatterings.met());
    }
}

void PathTracer::add_direct(State& state, const SurfaceHit& hit) const {
    if (!settings_.direct_light_sampling || (hit.bsdf->lobes() & kScattering) == 0) return;
    state.lights = lights_.at(hit.p, seen_side(state.ray, hit));
    for (std::size_t i = 0; i < lights_.choices(); ++i) {
        const float u = state.random.next();
        const LightChoice choice = lights_.choose(i, u, state.lights);
        const Rgb light = direct_light(state, hit, choice, state.random.next_2d());
        add(state, state.throughput * light, *choice.light, state.scatterings.scattered_in());
        if (state.result.told) tell(state, hit, choice, luminance(light) * choice.probability);
    }
}

/// What the light chosen sent here, so that it is known where paths meet such places again.
void PathTracer::tell(State& state, const SurfaceHit& hit, const LightChoice& choice,
                      float value) const {
    if (state.told_rays++ >= kToldRays) return;
    const Vec3 n = seen_side(state.ray, hit);
    state.result.told->push_back(
        {{hit.p.x, hit.p.y, hit.p.z}, {n.x, n.y, n.z}, choice.index, choice.probability, value});
}

Rgb PathTracer::direct_light(State& state, const SurfaceHit& hit, const LightChoice& choice,
                             const Vec2& u) const {
    const Vec3 wo = -state.ray.direction;
    DirectSample sample;
    if (!choice.light->sample_direct(hit.p, hit.ns, u, sample) ||
        !accept_sample(sample, *choice.light) || sample.pdf == 0) {
        return Rgb(0.0f);
    }
    const Rgb f = hit.bsdf->evaluate(wo, sample.wi, Transport::Radiance, kAllLobes);
    if (is_black(f) || is_black(sample.radiance)) return Rgb(0.0f);
    if (!filter_.accept_of_material(valid(f), hit.material)) return Rgb(0.0f);
    ++state.result.rays;
    const Rgb passed = scene_.transmittance(shadow_ray(hit, sample, state.ray.time));
    if (is_black(passed) || !filter_.accept_of_passage(valid(passed))) return Rgb(0.0f);
    const float pdf = sample.pdf * choice.probability;
    const float pdf_bounce = sample.delta ? 0.0f : hit.bsdf->pdf(wo, sample.wi, kAllLobes);
    if (!filter_.accept_of_material(valid_density(pdf_bounce), hit.material)) return Rgb(0.0f);
    const float weight = power_heuristic(pdf, pdf_bounce);
    const float cosine = std::abs(hit.ns.dot(sample.wi));
    return f * sample.radiance * passed * (cosine * weight / pdf);
}

/// Whether the path has had all the bounces that count.
bool PathTracer::is_spent(const State& state) const {
    return state.bounces - state.specular >= settings_.max_depth;
}

/// Draws the next direction; false when the path ends here.
bool PathTracer::scatter(State& state, const SurfaceHit& hit) const {
    // A path at its last bounce may still pass straight to a light, as its shadow rays may.
    const bool specular =
        hit.bsdf->lobes() == kSpecular && state.specular < settings_.specular_bounces;
    const bool last = is_spent(state) && !specular;
    if (last && (hit.bsdf->lobes() & kSpecular) == 0) return false;

    const Vec2 u = state.random.next_2d();
    BsdfSample sample;
    if (!hit.bsdf->sample(-state.ray.direction, u, state.random.next(), Transport::Radiance,
                          kAllLobes, sample)) {
        return false;
    }
    if (!sample.straight && last) return false;
    state.throughput *= sample.weight;
    const bool usable = valid(state.throughput) && valid_density(sample.pdf) && finite(sample.wi);
    if (!filter_.accept_of_material(usable, hit.material) || is_black(state.throughput))
        return false;
    state.ray = continue_ray(hit, sample, state.ray);
    if (sample.straight) return ++state.straight < kMaxStraight;

    ++state.bounces;
    if (specular) ++state.specular;
    state.scatterings.add((sample.lobe & kSpecular) != 0);
    state.left = {hit.p, hit.ns, (sample.lobe & kSpecular) != 0 ? 0.0f : sample.pdf, state.lights};
    return survives_roulette(state);
}

bool PathTracer::survives_roulette(State& state) const {
    if (state.bounces <= kRouletteStart || settings_.roulette == RouletteStrategy::None)
        return true;
    const float probability = settings_.roulette == RouletteStrategy::Probability
                                  ? settings_.continue_probability
                                  : std::min(1.0f, max_component(state.throughput));
    if (state.random.next() >= probability) return false;
    state.throughput /= probability;
    return true;
}

}  // namespace lxs
