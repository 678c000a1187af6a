// The photon pass.
#include "photon_pass.h"

#include <tbb/parallel_for.h>

#include "light_choice.h"
#include "stopwatch.h"

namespace aips {

PhotonPass::PhotonPass(const Scene& scene, const Settings& settings, Guide* guide)
    : scene_(scene), settings_(settings), guide_(guide), light_choice_(light_choice(scene)) {
    if (settings.photon_sampler == PhotonSampler::AdaptiveChains) chains_.emplace();
    if (guide && settings.debug_layers) bounces_.emplace(*guide, settings.max_nodes);
}

std::uint64_t PhotonPass::shoot(std::uint64_t pass, float time, const EyeImage& image,
                                const SearchRadii& radii, Refusals& refusals, PhotonFlux& flux) {
    flux.reset(image.visible_points.size(), image.groups);
    std::vector<Vec3> positions;
    positions.reserve(image.visible_points.size());
    for (const VisiblePoint& point : image.visible_points)
        positions.push_back(point.position);
    occupancy_.build(positions, radii.largest);
    if (guide_) guide_->begin_pass(positions, image.positions.size());
    if (chains_) chains_->begin_pass(positions, radii.largest, settings_.photons_per_pass);
    if (bounces_) bounces_->begin_pass();

    const std::uint32_t total = settings_.photons_per_pass;
    waiting_.clear();
    std::uint64_t iteration = 0;
    for (std::uint32_t first = 0; first < total; ++iteration) {
        const std::uint32_t wanted = guide_    ? guide_->iteration_paths(iteration)
                                     : chains_ ? chains_->round_paths()
                                               : kPlainIterationPaths;
        const std::uint32_t count = std::min(wanted, total - first);
        const bool guided = guide_ && guide_->guides(iteration);
        // A guide learns from all landings; without one only those near visible points matter.
        const PhotonInput input{scene_,
                                settings_,
                                light_choice_,
                                guided ? guide_ : nullptr,
                                guide_ ? nullptr : &occupancy_,
                                pass,
                                time,
                                bounces_ ? &*bounces_ : nullptr};
        {
            const Stopwatch watch(totals_.photon_seconds);
            iteration_.clear();
            totals_.counts +=
                chains_ ? chains_->trace(input, count, refusals, iteration_)
                        : trace_photons(input, pass * total, first, count, refusals, iteration_);
        }
        if (guide_) {
            const Stopwatch watch(totals_.guide_seconds);
            guide_->update(iteration_.landings());
            if (bounces_) bounces_->follow_splits();
        }
        if (waiting_.landings().size() + iteration_.landings().size() > kLandingCapacity) {
            gather(image, radii, refusals, flux);
        }
        keep_near_visible_points();
        first += count;
    }
    gather(image, radii, refusals, flux);
    if (chains_) flux.scale(chains_->end_pass());
    totals_.gathered += flux.gathered;
    return total;
}

void PhotonPass::keep_near_visible_points() {
    if (!guide_) {  // already done where they were stored
        waiting_.append(iteration_.landings());
        return;
    }
    for (const Landing& landing : iteration_.landings()) {
        if (occupancy_.near_visible_point(landing.position)) waiting_.append({&landing, 1});
    }
}

void PhotonPass::gather(const EyeImage& image, const SearchRadii& radii, Refusals& refusals,
                        PhotonFlux& flux) {
    const Stopwatch watch(totals_.gather_seconds);
    grid_.build(waiting_.landings(), radii.largest,
                [](std::uint32_t count, const Job& job) { tbb::parallel_for(0u, count, job); });
    gather_photons(image, grid_, radii, refusals, flux);
    waiting_.clear();
}

std::size_t PhotonPass::memory_bytes() const {
    return waiting_.memory_bytes() + iteration_.memory_bytes() + grid_.memory_bytes() +
           occupancy_.memory_bytes() + (chains_ ? chains_->memory_bytes() : 0) +
           (bounces_ ? bounces_->memory_bytes() : 0);
}

}  // namespace aips
