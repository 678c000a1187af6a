// What happens to a path between two surfaces, in a medium that scatters: free flights, and at each
// scattering the same two ways to the lights as on surfaces.
#include "lxs/sdk/medium.h"
#include "lxs/sdk/rays.h"
#include "path/path_state.h"

namespace lxs {

/// Flies along the ray until a collision or the end of the segment; true for a collision, at which
/// the ray's origin then is.
bool PathTracer::fly(State& state, const Medium& medium, float segment) const {
    const float u_channel = state.random.next();
    const Flight flight =
        medium.sample_flight(state.ray.origin, state.ray.direction, segment, state.throughput,
                             Vec2(u_channel, state.random.next()));
    state.throughput *= flight.weight;
    if (!flight.collides) return false;
    state.ray.origin += state.ray.direction * flight.distance;
    state.throughput *= medium.scattering_at(state.ray.origin);
    return true;
}

/// Direct light at the ray's origin, then a new direction; false when the path ends.
bool PathTracer::scatter_in_medium(State& state, const Medium& medium) const {
    if (is_black(state.throughput) || is_spent(state)) return false;
    if (settings_.direct_light_sampling) add_direct_in_medium(state, medium);
    const PhaseSample sample =
        medium.sample_phase(state.ray.direction, state.throughput, state.random.next_2d());
    state.left = {state.ray.origin, Vec3(0.0f), sample.pdf};
    state.throughput *= sample.weight;
    if (!filter_.accept_of_passage(valid(state.throughput))) return false;
    state.ray.direction = sample.direction;
    state.ray.t_max = std::numeric_limits<float>::infinity();
    ++state.bounces;
    state.scatterings.add(false);
    return survives_roulette(state);
}

void PathTracer::add_direct_in_medium(State& state, const Medium& medium) const {
    for (std::size_t i = 0; i < lights_.choices(); ++i) {
        const float u = state.random.next();
        const LightChoice choice = lights_.choose(i, u);
        const Rgb light = direct_light_in_medium(state, medium, choice, state.random.next_2d());
        add(state, state.throughput * light, *choice.light, state.scatterings.scattered_in());
    }
}

Rgb PathTracer::direct_light_in_medium(State& state, const Medium& medium,
                                       const LightChoice& choice, const Vec2& u) const {
    const Ray& ray = state.ray;
    DirectSample sample;
    if (!choice.light->sample_direct(ray.origin, Vec3(0.0f), u, sample) ||
        !accept_sample(sample, *choice.light) || sample.pdf == 0 || is_black(sample.radiance)) {
        return Rgb(0.0f);
    }
    ++state.result.rays;
    const Rgb passed =
        scene_.transmittance(shadow_ray_from_medium(ray.origin, sample, ray.time, ray.media));
    if (is_black(passed) || !filter_.accept_of_passage(valid(passed))) return Rgb(0.0f);
    const float cosine = ray.direction.dot(sample.wi);
    const float pdf = sample.pdf * choice.probability;
    const float weight =
        sample.delta ? 1.0f : power_heuristic(pdf, medium.phase_pdf(cosine, state.throughput));
    return medium.phase(cosine) * sample.radiance * passed * (weight / pdf);
}

}  // namespace lxs
