// The photon pass.
#include "photons/photon_pass.h"

#include "base/parallel_for.h"
#include "base/stopwatch.h"
#include "estimate/pixel_estimate.h"
#include "eye/light_choice.h"
#include "guides/adaptive/learning_weight.h"
#include "radii/curvature_probes.h"
#include "worth/pass_noise.h"

namespace aips {

PhotonPass::PhotonPass(const Scene& scene, const Settings& settings, Guide* guide,
                       const PixelImportance* importance)
    : scene_(scene), settings_(settings), guide_(guide), light_choice_(light_choice(scene)) {
    chained_ = settings.photon_sampler == PhotonSampler::AdaptiveChains;
    if (may_use_chains(settings)) chains_.emplace();
    if (settings.guide == GuideKind::Adaptive) {
        adaptive_.emplace(scene, settings, light_choice_, *importance);
    }
    if (guide && guide->needs_scores()) scores_.emplace(*importance);
    if (scene.media()) volume_.emplace(scene, settings);
    if (guide && settings.debug_layers) bounces_.emplace(*guide, settings.max_nodes);
}

void PhotonPass::begin_pass(std::uint64_t pass, const PassPhotons& photons, float time,
                            const EyeImage& image, const SearchRadii& radii) {
    const float reach = chained_ ? PhotonChains::reach(radii) : radii.reach();
    const bool reach_lasts = freezes_eye_pass(settings_.mode) && reach_ == reach;
    if (guide_ || adaptive_ || !reach_lasts) {
        positions_.reserve(image.positions.size());
        positions_of(image.visible_points, positions_);
        if (!reach_lasts) mark_reach(positions_, reach);
        const Stopwatch watch(totals_.guide_seconds);
        if (guide_) guide_->begin_pass(positions_, image.positions.size());
        if (scores_) scores_->begin_pass(image, positions_, radii);
        if (adaptive_)
            totals_.counts.rays += adaptive_->begin_pass(pass, time, image, positions_, radii);
    }
    if (chained_) chains_->begin_pass(photons.paths);
    if (bounces_) bounces_->begin_pass();
    waiting_.clear();
    if (volume_) volume_->begin_pass(pass, photons, image);
}

void PhotonPass::mark_reach(std::span<const Vec3> visible_points, float radius) {
    occupancy_.build(visible_points, radius, tbb_for);
    if (chained_) chains_->mark_reach(visible_points, radius);
    reach_ = radius;
}

void PhotonPass::shoot(std::uint64_t pass, const PassPhotons& photons, float time,
                       const EyeImage& image, const SearchRadii& radii, Refusals& refusals,
                       PhotonFlux& flux) {
    flux.reset(image.visible_points.size(), image.groups, radii.probes.size());
    begin_pass(pass, photons, time, image, radii);
    std::uint64_t iteration = 0;
    for (std::uint32_t first = 0; first < photons.paths; ++iteration) {
        const std::uint32_t count = std::min(iteration_paths(iteration), photons.paths - first);
        const std::size_t landings = waiting_.landings().size();
        const std::size_t collisions = volume_ ? volume_->waiting().size() : 0;
        PhotonInput input = input_of(pass, time, iteration);
        input.sequence_begin = sequence_begin(photons, first, input.emission != nullptr);
        if (input.emission) unguided_from_ = photons.before + first + count;
        trace(input, photons, first, count, refusals);
        learn(count);
        if (adaptive_) {
            // After learning: a guide learns from what photons really carried.
            const auto weight = float(learning_weight(photons.before + first));
            if (weight < 1) {
                waiting_.scale_power(landings, weight);
                if (volume_) volume_->scale_power(collisions, weight);
            }
        }
        if (waiting_.landings().size() > kLandingCapacity) gather(image, radii, refusals, flux);
        if (volume_ && volume_->full()) gather_in_media(image, refusals);
        first += count;
    }
    gather_in_media(image, refusals);
    gather(image, radii, refusals, flux);
    if (chained_) flux.scale(chains_->end_pass());
    if (photons.counted < photons.paths) {
        const double factor = double(photons.paths) / photons.counted;
        flux.scale(factor);
        if (volume_) volume_->scale_flux(float(factor));
    }
    totals_.gathered += flux.gathered;
}

PhotonInput PhotonPass::input_of(std::uint64_t pass, float time, std::uint64_t iteration) {
    PhotonInput input{scene_, settings_, light_choice_};
    input.pass = pass;
    input.time = time;
    if (guide_) {
        // No occupancy: it learns from landings that no visible point is near to.
        if (guide_->guides(iteration)) input.guide = guide_;
        input.store_owned = guide_->learns_from_owned();
        input.bounces = bounces_ ? &*bounces_ : nullptr;
    } else {
        input.occupancy = &occupancy_;
    }
    if (adaptive_) {
        input.emission = adaptive_->emission();
        input.survival = adaptive_->survival();
        input.score_mix = adaptive_->score_mix();
        input.split_landings = split_landings(settings_);
        input.log_one_of = adaptive_->log_one_of();
        input.guide = adaptive_->bounces();
        input.unguided_roulette = input.guide != nullptr;
        input.log_vertices = input.survival || input.guide;
    }
    return input;
}

std::uint32_t PhotonPass::iteration_paths(std::uint64_t iteration) const {
    if (guide_) return guide_->iteration_paths(iteration);
    return chained_ ? chains_->round_paths() : kPlainIterationPaths;
}

void PhotonPass::trace(const PhotonInput& input, const PassPhotons& photons, std::uint32_t first,
                       std::uint32_t count, Refusals& refusals) {
    const Stopwatch watch(totals_.photon_seconds);
    LandingStore& store = guide_ ? iteration_ : waiting_;
    totals_.counts += chained_ ? chains_->trace(input, count, refusals, store)
                               : tracer_.trace(input, photons.before, first, count, refusals, store,
                                               adaptive_ ? &log_ : nullptr,
                                               volume_ ? &volume_->waiting() : nullptr);
}

void PhotonPass::learn(std::uint32_t paths) {
    const Stopwatch watch(totals_.guide_seconds);
    if (adaptive_) {
        totals_.learned += adaptive_->learn(log_, waiting_.landings(), paths);
        log_.clear();
    }
    if (!guide_) return;
    const std::span<const Landing> landings = iteration_.landings();
    guide_->update(landings, scores_ ? scores_->of(landings) : std::span<const double>());
    if (bounces_) bounces_->follow_splits();
    for (const Landing& landing : iteration_.landings()) {
        if (!landing.owned_by_shadow_rays && occupancy_.near_visible_point(landing.position))
            waiting_.append({&landing, 1});
    }
    iteration_.clear();
}

void PhotonPass::gather(const EyeImage& image, const SearchRadii& radii, Refusals& refusals,
                        PhotonFlux& flux) {
    const Stopwatch watch(totals_.gather_seconds);
    grid_.build(waiting_.landings(), radii.largest, tbb_for);
    gather_photons(image, grid_, radii, refusals, flux);
    if (!radii.probes.empty()) {
        // A grid of their own: one for radii so much wider would slow the gather.
        grid_.build(waiting_.landings(), radii.probe_radius, tbb_for);
        gather_probes(image, grid_, radii, flux.probes);
    }
    waiting_.clear();
}

void PhotonPass::gather_in_media(const EyeImage& image, Refusals& refusals) {
    if (!volume_) return;
    const Stopwatch watch(totals_.gather_seconds);
    const std::uint64_t before = volume_->gathered();
    volume_->gather(image, refusals);
    totals_.gathered += volume_->gathered() - before;
}

void PhotonPass::estimate(const EyeImage& image, const PhotonFlux& flux, const SearchRadii& radii,
                          std::uint64_t photon_paths, Refusals& refusals,
                          std::vector<Rgb>& radiance, std::vector<float>* variances) const {
    estimate_pixels(image, flux, radii, photon_paths, refusals, radiance);
    // Of surfaces alone, as their flux is: what media bring is added to both.
    if (variances) photon_variances(image, radiance, flux, *variances);
    if (volume_) {
        volume_->add_to(image, photon_paths, refusals, radiance,
                        variances ? std::span<float>(*variances) : std::span<float>());
    }
}

// What is marked around visible points is found anew by begin_pass().
void PhotonPass::state(StateArchive& archive) {
    totals_.counts.state(archive);
    archive.value(totals_.gathered);
    archive.value(unguided_from_);
    if (chains_) chains_->state(archive);
    if (adaptive_) adaptive_->state(archive);
    if (volume_) volume_->state(archive);
}

void PhotonPass::state_of_seconds(StateArchive& archive) {
    for (double* seconds :
         {&totals_.photon_seconds, &totals_.gather_seconds, &totals_.guide_seconds})
        archive.amount(*seconds);
}

std::size_t PhotonPass::memory_bytes() const {
    return positions_.capacity() * sizeof(Vec3) + tracer_.memory_bytes() + waiting_.memory_bytes() +
           iteration_.memory_bytes() + grid_.memory_bytes() + occupancy_.memory_bytes() +
           (volume_ ? volume_->memory_bytes() : 0) + (chains_ ? chains_->memory_bytes() : 0) +
           (bounces_ ? bounces_->memory_bytes() : 0) + (scores_ ? scores_->memory_bytes() : 0) +
           (adaptive_ ? adaptive_->memory_bytes() + log_.memory_bytes() : 0);
}

}  // namespace aips
