// The photon pass.
#include "photon_pass.h"

#include "light_choice.h"
#include "parallel_for.h"
#include "stopwatch.h"

namespace aips {

PhotonPass::PhotonPass(const Scene& scene, const Settings& settings, Guide* guide)
    : scene_(scene), settings_(settings), guide_(guide), light_choice_(light_choice(scene)) {
    if (settings.photon_sampler == PhotonSampler::AdaptiveChains) chains_.emplace();
    if (guide && settings.debug_layers) bounces_.emplace(*guide, settings.max_nodes);
}

void PhotonPass::begin_pass(const EyeImage& image, float largest_radius) {
    const bool reach_lasts = freezes_eye_pass(settings_.mode) && reach_ == largest_radius;
    if (guide_ || !reach_lasts) {
        std::vector<Vec3> positions;
        positions.reserve(image.visible_points.size());
        for (const VisiblePoint& point : image.visible_points)
            positions.push_back(point.position);
        if (!reach_lasts) mark_reach(positions, largest_radius);
        if (guide_) guide_->begin_pass(positions, image.positions.size());
    }
    if (chains_) chains_->begin_pass(settings_.photons_per_pass);
    if (bounces_) bounces_->begin_pass();
    waiting_.clear();
}

void PhotonPass::mark_reach(std::span<const Vec3> visible_points, float radius) {
    occupancy_.build(visible_points, radius);
    if (chains_) chains_->mark_reach(visible_points, radius);
    reach_ = radius;
}

std::uint64_t PhotonPass::shoot(std::uint64_t pass, float time, const EyeImage& image,
                                const SearchRadii& radii, Refusals& refusals, PhotonFlux& flux) {
    flux.reset(image.visible_points.size(), image.groups);
    begin_pass(image, radii.largest);
    const std::uint32_t total = settings_.photons_per_pass;
    std::uint64_t iteration = 0;
    for (std::uint32_t first = 0; first < total; ++iteration) {
        const std::uint32_t count = std::min(iteration_paths(iteration), total - first);
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
        trace(input, first, count, refusals);
        if (guide_) learn();
        if (waiting_.landings().size() > kLandingCapacity) gather(image, radii, refusals, flux);
        first += count;
    }
    gather(image, radii, refusals, flux);
    if (chains_) flux.scale(chains_->end_pass());
    totals_.gathered += flux.gathered;
    return total;
}

std::uint32_t PhotonPass::iteration_paths(std::uint64_t iteration) const {
    if (guide_) return guide_->iteration_paths(iteration);
    return chains_ ? chains_->round_paths() : kPlainIterationPaths;
}

void PhotonPass::trace(const PhotonInput& input, std::uint32_t first, std::uint32_t count,
                       Refusals& refusals) {
    const Stopwatch watch(totals_.photon_seconds);
    LandingStore& store = guide_ ? iteration_ : waiting_;
    totals_.counts += chains_ ? chains_->trace(input, count, refusals, store)
                              : tracer_.trace(input, input.pass * settings_.photons_per_pass, first,
                                              count, refusals, store);
}

void PhotonPass::learn() {
    const Stopwatch watch(totals_.guide_seconds);
    guide_->update(iteration_.landings());
    if (bounces_) bounces_->follow_splits();
    for (const Landing& landing : iteration_.landings()) {
        if (occupancy_.near_visible_point(landing.position)) waiting_.append({&landing, 1});
    }
    iteration_.clear();
}

void PhotonPass::gather(const EyeImage& image, const SearchRadii& radii, Refusals& refusals,
                        PhotonFlux& flux) {
    const Stopwatch watch(totals_.gather_seconds);
    grid_.build(waiting_.landings(), radii.largest, tbb_for);
    gather_photons(image, grid_, radii, refusals, flux);
    waiting_.clear();
}

std::size_t PhotonPass::memory_bytes() const {
    return tracer_.memory_bytes() + waiting_.memory_bytes() + iteration_.memory_bytes() +
           grid_.memory_bytes() + occupancy_.memory_bytes() +
           (chains_ ? chains_->memory_bytes() : 0) + (bounces_ ? bounces_->memory_bytes() : 0);
}

}  // namespace aips
