// The photon pass.
#include "photons/photon_pass.h"

#include "base/assign_all.h"
#include "base/parallel_for.h"
#include "base/side_by_side.h"
#include "base/stopwatch.h"
#include "contribution/pass_noise.h"
#include "estimate/constants.h"
#include "estimate/photon_energy.h"
#include "estimate/pixel_estimate.h"
#include "radii/curvature_probes.h"

namespace aips {

PhotonPass::PhotonPass(const Scene& scene, const Settings& settings,
                       const DiscreteDistribution& light_choice, std::unique_ptr<PassGuide> guide,
                       std::unique_ptr<PhotonSource> source)
    : scene_(scene),
      settings_(settings),
      light_choice_(light_choice),
      guide_(std::move(guide)),
      source_(std::move(source)) {
    if (scene.media()) volume_.emplace(scene, settings);
}

void PhotonPass::begin_pass(std::uint64_t pass, const PassPhotons& photons, float time,
                            const EyeImage& image, const GatherRadii& radii, VolumeWants wants) {
    const float reach = source_->reach(radii);
    const bool reach_lasts = freezes_eye_pass(settings_.mode) && reach_ == reach;
    if (guide_->wants_points() || !reach_lasts) {
        positions_.reserve(image.positions.size());
        positions_of(image.visible_points, positions_);
        if (!reach_lasts) mark_reach(reach);
        const Stopwatch watch(totals_.guide_seconds);
        totals_.counts.rays += guide_->begin_pass({pass, time, image, positions_, radii});
    }
    source_->begin_pass(photons);
    waiting_.clear();
    if (volume_) volume_->begin_pass(pass, time, photons, image, wants);
}

void PhotonPass::mark_reach(float radius) {
    occupancy_.build(positions_, radius, tbb_for);
    source_->mark_reach(positions_, radius);
    reach_ = radius;
}

void PhotonPass::shoot(std::uint64_t pass, const PassPhotons& photons, float time,
                       const EyeImage& image, const GatherRadii& radii, InvalidSampleFilter& filter,
                       PhotonFlux& flux, PhotonOcclusion* occlusion) {
    flux.reset(image.visible_points.size(), image.groups, radii.probes.size());
    begin_pass(pass, photons, time, image, radii, {flux.wants_parts, flux.wants_bias});
    pass_light_.clear();
    std::uint64_t iteration = 0;
    for (std::uint32_t first = 0; first < photons.paths; ++iteration) {
        const std::uint32_t most = guide_->iteration_paths(iteration, source_->iteration_paths());
        const IterationPaths paths{photons, first, std::min(most, photons.paths - first)};
        PhotonInput input = input_of(pass, time, iteration);
        input.ranks = image.owners.ranks;
        run_iteration(input, paths, filter);
        if (waiting_.photons().size() > kWaitingPhotons)
            gather(image, radii, filter, flux, occlusion);
        if (volume_ && volume_->full()) gather_in_media(image, filter);
        first += paths.count;
    }
    end_iterations(image, radii, filter, flux, occlusion);
    const double factor = source_->end_pass();
    if (factor != 1) flux.scale(factor);
    flux_factor_ = factor * scale_to_counted(photons, flux);
    totals_.gathered += flux.counts.photons;
    totals_.counts.rays += flux.counts.rays;
}

void PhotonPass::count_transport(const PassPhotons& photons, std::uint32_t passes,
                                 const EyeImage& image, double brightened) {
    if (!settings_.transport_statistics || image.telling_paths == 0) return;
    const double paths = double(photons.paths) * double(image.telling_paths);
    const double weight = photons.weight * passes;
    totals_.light.add(pass_light_, weight * flux_factor_ * brightened / paths);
    totals_.weights += weight;
}

PhotonInput PhotonPass::input_of(std::uint64_t pass, float time, std::uint64_t iteration) {
    PhotonInput input{scene_, settings_, light_choice_};
    input.pass = pass;
    input.time = time;
    input.occupancy = &occupancy_;
    guide_->guide(iteration, input);
    return input;
}

void PhotonPass::run_iteration(PhotonInput& input, const IterationPaths& paths,
                               InvalidSampleFilter& filter) {
    const PassPhotons& photons = paths.photons;
    const std::size_t stored = waiting_.photons().size();
    const std::size_t collisions = volume_ ? volume_->waiting().size() : 0;
    input.sequence_begin = sequence_begin(photons, paths.first, input.emission != nullptr);
    if (input.emission) unguided_from_ = photons.before + paths.first + paths.count;
    study_beside(input.ranks, [&] {
        const Stopwatch watch(totals_.photon_seconds);
        const PathTraces traces{guide_->photons(waiting_), guide_->log(),
                                volume_ ? &volume_->waiting() : nullptr};
        totals_.counts += source_->trace(input, paths, filter, traces);
    });
    {
        const Stopwatch watch(totals_.guide_seconds);
        totals_.learned += guide_->learn(paths.count, occupancy_, waiting_);
    }
    // After learning: a guide learns from what photons really carried.
    const auto weight =
        static_cast<float>(guide_->weight(photons.known + photons.before + paths.first));
    if (weight < 1) {
        waiting_.scale_power(stored, weight);
        if (volume_) volume_->scale_power(collisions, weight);
    }
}

/// Ranks tell each other what they found in one order: theirs study first. What comes of it is the
/// same.
template <class Work>
void PhotonPass::study_beside(Ranks* ranks, const Work& work) {
    const auto study = [&] {
        const Stopwatch watch(totals_.guide_seconds);
        guide_->study();
    };
    if (!guide_->has_studies()) return work();
    if (!ranks) return side_by_side(work, study);
    study();
    work();
}

void PhotonPass::end_iterations(const EyeImage& image, const GatherRadii& radii,
                                InvalidSampleFilter& filter, PhotonFlux& flux,
                                PhotonOcclusion* occlusion) {
    study_beside(image.owners.ranks, [&] {
        gather_in_media(image, filter);
        gather(image, radii, filter, flux, occlusion);
    });
    if (volume_) volume_->end_pass(image);
    const Stopwatch watch(totals_.guide_seconds);
    totals_.learned += guide_->end_pass();
}

double PhotonPass::scale_to_counted(const PassPhotons& photons, PhotonFlux& flux) {
    if (!(photons.counted < photons.paths)) return 1;
    const double factor = double(photons.paths) / photons.counted;
    flux.scale(factor);
    if (volume_) volume_->scale_flux(float(factor));
    return factor;
}

void PhotonPass::gather(const EyeImage& image, const GatherRadii& radii,
                        InvalidSampleFilter& filter, PhotonFlux& flux, PhotonOcclusion* occlusion) {
    const Stopwatch watch(totals_.gather_seconds);
    grid_.build(waiting_.photons(), radii.largest, tbb_for, image.visible_points.size());
    const GatherCounts before = flux.counts;
    SharedWork work = work_on_points(image.owners, &filter);
    gather_photons(image, grid_, radii, filter, flux, occlusion);
    exchange_flux(image, before, work, flux, occlusion);
    if (settings_.transport_statistics)
        add_photon_energy(image, grid_, waiting_.photons(), radii, occlusion, pass_light_);
    if (!radii.probes.empty()) {
        // A grid of their own: one for radii so much wider would slow the gather.
        grid_.build(waiting_.photons(), radii.probe_radius, tbb_for);
        gather_probes(image, grid_, radii, occlusion, flux.probes);
    }
    waiting_.clear();
}

void PhotonPass::gather_in_media(const EyeImage& image, InvalidSampleFilter& filter) {
    if (!volume_) return;
    const Stopwatch watch(totals_.gather_seconds);
    const std::uint64_t before = volume_->gathered(), rays_before = volume_->rays();
    volume_->gather(image, filter);
    totals_.beam_rays += volume_->rays() - rays_before;
    totals_.gathered_in_media += volume_->gathered() - before;
}

void PhotonPass::estimate(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                          std::uint64_t photon_paths, InvalidSampleFilter& filter,
                          std::vector<Rgb>& radiance, PhotonVariances* variances) const {
    estimate_pixels(image, flux, radii, photon_paths, filter, radiance);
    // Of surfaces alone, as their flux is.
    if (variances) photon_variances(image, radiance, flux, variances->surfaces);
    if (!volume_) return;
    if (variances) assign_all(variances->beams, image.positions.size(), 0.0f);
    volume_->add_to(image, photon_paths, filter, radiance,
                    variances ? std::span<float>(variances->beams) : std::span<float>());
}

void PhotonPass::estimate_discs(const EyeImage& image, const PhotonFlux& flux,
                                const GatherRadii& radii, std::uint64_t photon_paths,
                                DiscEstimates& discs) const {
    aips::estimate_discs(image, flux, radii, photon_paths, discs);
    if (volume_ && photon_paths > 0) volume_->add_discs(image, photon_paths, discs);
}

void PhotonPass::estimate_parts(const EyeImage& image, const PhotonFlux& flux,
                                const GatherRadii& radii, std::uint64_t photon_paths,
                                std::span<const Rgb> radiance, std::vector<Rgb>& parts) const {
    const std::vector<Rgb> of_media =
        volume_ ? volume_->parts(image, photon_paths) : std::vector<Rgb>();
    aips::estimate_parts(image, flux, radii, photon_paths, of_media, radiance, parts);
}

// What is marked around visible points is found anew by begin_pass().
void PhotonPass::state(StateArchive& archive) {
    totals_.counts.state(archive);
    archive.value(totals_.gathered);
    archive.value(totals_.gathered_in_media);
    archive.value(totals_.beam_rays);
    totals_.light.state(archive);
    archive.amount(totals_.weights);
    archive.value(unguided_from_);
    source_->state(archive);
    guide_->state(archive);
    if (volume_) volume_->state(archive);
}

void PhotonPass::learned(LearnedParts& parts) {
    guide_->learned(parts);
}

void PhotonPass::state_of_seconds(StateArchive& archive) {
    for (double* seconds :
         {&totals_.photon_seconds, &totals_.gather_seconds, &totals_.guide_seconds})
        archive.amount(*seconds);
}

void PhotonPass::add_to(EngineStatistics& s) const {
    s.photon_paths += totals_.counts.paths;
    s.photon_rays += totals_.counts.rays + totals_.beam_rays;
    s.photons += totals_.counts.photons;
    s.split_off += totals_.counts.split_off;
    s.bounces += totals_.counts.bounces;
    s.guided_bounces += totals_.counts.guided_bounces;
    s.pruned_paths += totals_.counts.pruned;
    s.gathered += totals_.gathered + totals_.gathered_in_media;
    s.photon_seconds += totals_.photon_seconds;
    s.gather_seconds += totals_.gather_seconds;
    s.guide_seconds += totals_.guide_seconds;
    source_->add_to(s);
    guide_->add_to(s);
    totals_.counts.statistics.add_to(s.transport);
    const auto& light = totals_.light.sums();
    for (std::size_t i = 0; i < light.size(); ++i)
        sum_at(s.transport.lights, i).photons += light[i] / totals_.weights;
}

std::size_t PhotonPass::memory_bytes() const {
    return positions_.capacity() * sizeof(Vec3) + waiting_.memory_bytes() + grid_.memory_bytes() +
           occupancy_.memory_bytes() + (volume_ ? volume_->memory_bytes() : 0) +
           source_->memory_bytes() + guide_->memory_bytes();
}

}  // namespace aips
