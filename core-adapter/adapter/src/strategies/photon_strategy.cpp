// Light by photons.
#include "strategies/photon_strategy.h"

#include "base/parallel_for.h"
#include "base/stopwatch.h"
#include "eye/light_choice.h"
#include "guides/adaptive/adaptive_guide.h"
#include "guides/paper/paper_guide.h"
#include "photons/exploration.h"
#include "plan/memory_bound.h"
#include "plan/pass_work.h"
#include "strategies/constants.h"

namespace aips {
namespace {

std::unique_ptr<Guide> make_guide(const Scene& scene, const Plan& plan) {
    if (plan.guide() != GuideKind::Paper) return nullptr;
    return std::make_unique<PaperGuide>(scene.bounds(), plan.settings());
}

}  // namespace

PhotonStrategy::PhotonStrategy(const Host& host, Plan& plan, std::uint32_t eye_paths)
    : scene_(host.scene),
      film_(host.film),
      plan_(plan),
      settings_(plan.settings()),
      eye_paths_(eye_paths),
      skip_log_(host.log),
      light_choice_(light_choice(host.scene)),
      guide_(make_guide(host.scene, plan)),
      schedule_(make_schedule()),
      importance_(make_importance()),
      planner_(pixels(), eye_paths),
      photon_pass_(host.scene, settings_, light_choice_, make_pass_guide(), make_source()),
      radius_policy_(make_radii()) {
    if (settings_.continue_eye_paths)
        shared_.emplace(scene_, settings_, film_.width(), film_.height());
    flux_.most_points = most_visible_points(settings_, eye_paths);
    flux_.wants_shareable = shared_.has_value();
    flux_.wants_glossy = settings_.caustics_on_gloss;
    flux_.wants_parts = film_.layers_wanted().parts;
    flux_.wants_bias = film_.layers_wanted().bias && plan_.needs.photons;
    flux_.wants_inner = flux_.wants_bias || settings_.narrow_radii;
    if (plans_passes()) noise_.emplace(film_.width(), film_.height());
    if (settings_.photon_occlusion)
        occlusion_.emplace(scene_, settings_.seed, film_.width(), film_.height());
    if (settings_.correct_edges)
        edges_.emplace(scene_, settings_, film_.width(), film_.height(),
                       occlusion_ ? &*occlusion_ : nullptr);
    if (settings_.debug_layers) layers_.emplace(film_, guide_.get());
}

PhotonSchedule PhotonStrategy::make_schedule() const {
    // What photons bring to media is kept from pass to pass.
    const bool turns = settings_.photon_turns && settings_.continue_eye_paths && !scene_.media();
    return {settings_, eye_paths_, plan_.needs.photons, plan_.learns(), turns};
}

std::unique_ptr<RadiusPolicy> PhotonStrategy::make_radii() const {
    return make_radius_policy(settings_, scene_, film_.width(), film_.height());
}

std::optional<PixelImportance> PhotonStrategy::make_importance() const {
    if (!plan_.learns() && !plans_passes() && !(guide_ && guide_->needs_scores())) return {};
    return PixelImportance(film_.width(), film_.height());
}

/// Before the first photon path.
void PhotonStrategy::run_pilot_pass(const StrategyPass& pass) {
    if (!plan_.has_pilot_pass()) return;
    const Stopwatch watch(plan_seconds_);
    const double radius = initial_radius(settings_, pass.image, smallest_radius(scene_));
    const SeenPaths seen =
        trace_pilot_pass(scene_, settings_, pass.time, pass.image, static_cast<float>(radius));
    // What another render learned may have chosen a way already.
    const PhotonWay way = photon_way(seen);
    if (way != plan_.way) take_way(way);
    if (plan_.way == PhotonWay::Unguided) return skip_log_.left_out_guide(seen);
    if (!settings_.guide_chains || !seen_too_seldom(seen)) return;
    const Exploration exploration = explore_starts(scene_, settings_, light_choice_, pass.time,
                                                   pass.image, static_cast<float>(radius));
    photon_pass_.begin_with(exploration.starts);
    if (!exploration.starts.empty()) schedule_.explored(exploration.paths);
    skip_log_.explored(exploration);
}

void PhotonStrategy::take_way(PhotonWay way) {
    plan_.way = way;
    // The brightness of pixels depends on no way.
    if (auto made = make_importance(); !made || !importance_) importance_ = std::move(made);
    photon_pass_.take(make_pass_guide());
    schedule_.begin_anew(make_schedule());
    radius_policy_ = make_radii();
    noise_.reset();
    if (plans_passes()) noise_.emplace(film_.width(), film_.height());
}

std::unique_ptr<PassGuide> PhotonStrategy::make_pass_guide() const {
    const PixelImportance* importance = importance_ ? &*importance_ : nullptr;
    if (guide_) return make_paper_pass_guide(*guide_, settings_, importance);
    if (plan_.learns()) {
        return make_adaptive_pass_guide(scene_, settings_, light_choice_, *importance);
    }
    return std::make_unique<PassGuide>();
}

std::unique_ptr<PhotonSource> PhotonStrategy::make_source() const {
    return make_photon_source(plan_.chains());
}

CarriedLight PhotonStrategy::carry(const StrategyPass& pass, PassReport& report) {
    const EyeImage& image = pass.image;
    if (pass.number == 0 && !image.visible_points.empty()) run_pilot_pass(pass);
    before_ = photon_pass_.totals();
    radii_ = {};
    shot_ = 0;
    in_turn_ = schedule_.shoots();
    const PassPhotons photons = schedule_.next();
    if (!in_turn_) {
        leave_out_photons(image);
    } else if (!plan_.needs.photons || (image.visible_points.empty() && image.beams.empty())) {
        flux_.reset(image.visible_points.size(), image.groups);
        if (plan_.needs.photons) {
            skip_log_.no_visible_points(freezes_eye_pass(settings_.mode));
            radiance_.assign(image.radiance.size(), Rgb{});
            parts_.assign(flux_.wants_parts ? image.positions.size() * kImageParts : 0, Rgb{});
        }
    } else {
        shoot(pass, photons, report);
    }
    return {.radiance = counted(),
            .mean = PassMean::Weighted,
            .weight = photons.weight,
            .parts = parts_};
}

void PhotonStrategy::shoot(const StrategyPass& pass, const PassPhotons& photons,
                           PassReport& report) {
    const EyeImage& image = pass.image;
    const bool any_points = !image.visible_points.empty();
    shot_ = photons.paths;
    variances_.thinning = photons.thinning;
    if (any_points) radii_ = radius_policy_->before_pass(photons, image);
    PhotonOcclusion* const occlusion = occlusion_ ? &*occlusion_ : nullptr;
    if (occlusion) {
        occlusion->begin_pass(pass.number, pass.time, image);
        if (importance_) importance_->set_occlusion(*occlusion);
    }
    photon_pass_.shoot(pass.number, photons, pass.time, image, radii_, pass.filter, flux_,
                       occlusion);
    if (edges_ && any_points) {
        const Stopwatch watch(edge_seconds_);
        report.rays += edges_->correct(pass.number, pass.time, image, radii_, flux_);
    }
    if (occlusion) occlusion->end_pass(image);
    photon_pass_.count_transport(photons, schedule_.turns(), image,
                                 edges_ ? edges_->brightened() : 1);
    photon_pass_.estimate(image, flux_, radii_, photons.paths, pass.filter, radiance_,
                          noise_ && !shared_ ? &variances_ : nullptr);
    if (any_points) radius_policy_->after_pass(flux_);
    if (shared_) join_eye_share(pass, photons);
    if (flux_.wants_parts)
        photon_pass_.estimate_parts(image, flux_, radii_, photons.paths / schedule_.turns(),
                                    counted(), parts_);
    report.radius = radii_.mean;
    report.photon_paths += shot_;
    const PhotonPassTotals& after = photon_pass_.totals();
    report.rays += after.counts.rays - before_.counts.rays + after.beam_rays - before_.beam_rays;
}

/// Later passes are steered by photons as they came; in the image they count for several passes.
void PhotonStrategy::join_eye_share(const StrategyPass& pass, const PassPhotons& photons) {
    const std::uint32_t turns = schedule_.turns();
    if (turns > 1) {
        counted_.resize(radiance_.size());
        for_all(radiance_.size(),
                [&](std::size_t i) { counted_[i] = radiance_[i] * float(turns - 1); });
    }
    shared_->join({pass.number, photons.paths}, pass.image, flux_, radii_, *importance_, radiance_);
    if (turns > 1) for_all(radiance_.size(), [&](std::size_t i) { counted_[i] += radiance_[i]; });
}

/// Eye paths go on as in passes that shoot.
void PhotonStrategy::leave_out_photons(const EyeImage& image) {
    flux_.reset(image.visible_points.size(), image.groups);
    assign_all(radiance_, image.radiance.size(), Rgb{});
    shared_->go_on_alone(image, radiance_);
    if (flux_.wants_parts) photon_pass_.estimate_parts(image, flux_, 1.0f, 1, radiance_, parts_);
}

/// What photons and continued eye paths bring to the image in this pass.
const std::vector<Rgb>& PhotonStrategy::counted() const {
    return in_turn_ && shot_ > 0 && schedule_.turns() > 1 ? counted_ : radiance_;
}

void PhotonStrategy::end_pass(const StrategyPass& pass, const FilmPass& film_pass) {
    if (layers_) show_layers(pass.image, film_pass);
    if (flux_.wants_bias && in_turn_) show_bias(pass.image, film_pass);
    const PassNoise noise = learn_noise(pass.image);
    const PhotonPassTotals& after = photon_pass_.totals();
    if (in_turn_) {
        planner_.add({.number = pass.number,
                      .work = pass_work(pass.eye_paths, pass.eye_rays, before_, after),
                      .continued_rays = shared_ && shot_ > 0 ? shared_->continued_rays() : 0,
                      .points = double(pass.image.visible_points.size()),
                      .photon_paths = shot_,
                      .thinning = variances_.thinning,
                      .noise = noise});
    }
    schedule_.end_pass();
    if (plans_passes() && planner_.plans_before(pass.number + 1)) plan_from(pass.number + 1);
    skip_log_.after_pass(photon_pass_.guide().adaptive(), after.counts);
}

void PhotonStrategy::show_layers(const EyeImage& image, const FilmPass& film_pass) {
    const PassGuide& guide = photon_pass_.guide();
    layers_->add_pass(image, flux_, radii_, film_pass, guide.bounces());
    const BounceGuide* tables = guide.adaptive() ? guide.adaptive()->bounces() : nullptr;
    if (tables) layers_->add_tables(image, tables->tables());
}

void PhotonStrategy::show_bias(const EyeImage& image, const FilmPass& film_pass) {
    photon_pass_.estimate_discs(image, flux_, radii_, shot_, discs_);
    film_.add_bias({.positions = image.positions,
                    .whole = discs_.whole,
                    .half = discs_.half,
                    .weight = film_pass.photon_weight * schedule_.turns()});
}

/// What pass `pass` and those that follow do.
void PhotonStrategy::plan_from(std::uint64_t pass) {
    PlanFacts facts = planner_.take(pass);
    facts.turns = schedule_.turns();
    facts.independent = !plan_.chains();
    if (adapts_radius(settings_)) facts.squared_error = kErrorOverVariance;
    if (shared_) shared_->add_to(facts, *importance_);
    const PassPlan plan = plan_passes(facts, schedule_.limits());
    if (shared_) shared_->take(plan, pass);
    schedule_.take(plan);
    skip_log_.planned(plan);
}

/// The pass's image is known.
PassNoise PhotonStrategy::learn_noise(const EyeImage& image) {
    PassNoise noise;
    if (!importance_ || shot_ == 0) return noise;
    const Stopwatch watch(plan_seconds_);
    pixel_luminances(image, radiance_, film_.width(), film_.height(), seen_);
    if (noise_) noise = noise_->add_pass(seen_, variances_, shot_, *importance_);
    add_emitter_rests(image, seen_);
    importance_->add_pass(seen_);
    return noise;
}

void PhotonStrategy::state(StateArchive& archive, const EyeImage& image) {
    skip_log_.state(archive);
    plan_.state(archive);
    if (archive.restoring() && plan_.way != PhotonWay::Guided) take_way(plan_.way);
    schedule_.state(archive);
    if (importance_) importance_->state(archive);
    if (noise_) noise_->state(archive);
    planner_.state(archive);
    if (shared_) shared_->state(archive);
    photon_pass_.state(archive);
    radius_policy_->state(archive, image);
    if (edges_) edges_->state(archive);
    if (occlusion_) occlusion_->state(archive);
    if (layers_) layers_->state(archive);
}

void PhotonStrategy::learned(LearnedParts& parts) {
    if (!plan_.needs.photons) return;
    // First, as it decides on what others are parts of.
    parts.part("way of photons", 0, [&](StateArchive& archive) {
        PhotonWay way = plan_.way;
        archive.value(way, PhotonWay::Unguided);
        // A pilot pass judges it anew; without one nothing would.
        if (way != plan_.way && plan_.allows(way) && plan_.has_pilot_pass()) take_way(way);
    });
    schedule_.learned(parts);
    if (importance_) importance_->learned(parts);
    if (shared_) shared_->learned(parts);
    photon_pass_.learned(parts);
}

void PhotonStrategy::state_of_seconds(StateArchive& archive) {
    photon_pass_.state_of_seconds(archive);
    archive.amount(plan_seconds_);
    archive.amount(edge_seconds_);
}

void PhotonStrategy::add_to(EngineStatistics& s) const {
    photon_pass_.add_to(s);
    if (shared_) shared_->add_to(s);
    s.photons_per_pass = schedule_.next().paths;
    s.plan_seconds += plan_seconds_;
    s.gather_seconds += edge_seconds_;
    s.transport.skipped.insert(s.transport.skipped.end(), skip_log_.said().begin(),
                               skip_log_.said().end());
}

std::size_t PhotonStrategy::memory_bytes() const {
    return flux_.memory_bytes() +
           (radiance_.capacity() + counted_.capacity() + parts_.capacity() +
            discs_.whole.capacity() + discs_.half.capacity()) *
               sizeof(Rgb) +
           variances_.memory_bytes() + seen_.capacity() * sizeof(PixelLuminance) +
           photon_pass_.memory_bytes() + radius_policy_->memory_bytes() +
           (edges_ ? edges_->memory_bytes() : 0) + (occlusion_ ? occlusion_->memory_bytes() : 0) +
           (importance_ ? importance_->memory_bytes() : 0) + (noise_ ? noise_->memory_bytes() : 0) +
           (shared_ ? shared_->memory_bytes() : 0) + (layers_ ? layers_->memory_bytes() : 0);
}

std::size_t PhotonStrategy::memory_bound_bytes() const {
    // Of paths, of visible points, and of beams, kept and estimated.
    const std::size_t parts =
        flux_.wants_parts ? sizeof(Rgb) * eye_paths_ * (kImageParts + 3 * kPhotonParts) : 0;
    const std::size_t discs = flux_.wants_bias ? 4 * sizeof(Rgb) * eye_paths_ : 0;
    const std::size_t photons =
        parts + discs + photon_memory_bound(scene_, plan_.needs, eye_paths_, pixels());
    if (!layers_) return photons;
    return photons +
           DebugLayers::memory_bound_bytes(pixels(), eye_paths_, guide_ ? settings_.max_nodes : 0);
}

}  // namespace aips
