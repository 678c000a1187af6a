// The pass loop: eye pass, photon pass, estimate, film.
#include "aips/adapter/engine.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "aips/core/random.h"
#include "debug_layers.h"
#include "guide_scout.h"
#include "memory_bound.h"
#include "needs.h"
#include "paper_guide.h"
#include "pass_noise.h"
#include "pass_work.h"
#include "photon_pass.h"
#include "photon_schedule.h"
#include "pixel_importance.h"
#include "pixel_luminance.h"
#include "precision_warning.h"
#include "radius_policy.h"
#include "same_render.h"
#include "skip_log.h"
#include "stopwatch.h"

namespace aips {
namespace {

/// Eye paths per pixel of a frozen eye pass unless hitpointperpass says otherwise.
constexpr std::uint32_t kFrozenPathsPerPixel = 4;

std::uint32_t eye_paths_per_pass(const Host& host, const Settings& settings) {
    if (settings.hit_points_per_pass) return settings.hit_points_per_pass;
    const std::uint64_t pixels = std::uint64_t{host.film.width()} * host.film.height();
    const std::uint64_t paths =
        freezes_eye_pass(settings.mode) ? pixels * kFrozenPathsPerPixel : pixels;
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(paths, kMost));
}

std::unique_ptr<Guide> make_guide(const Scene& scene, const Settings& settings) {
    if (settings.guide != GuideKind::Paper) return nullptr;
    return std::make_unique<PaperGuide>(scene.bounds(), settings);
}

}  // namespace

class Engine::State {
  public:
    State(const Host& host, const Settings& settings)
        : host_(host),
          needs_(analyse(host.scene, settings)),
          skip_log_(host.log),
          settings_(needs_.settings),
          eye_paths_(eye_paths_per_pass(host, settings)),
          direct_light_(host.scene, settings_.learn_lights),
          refusals_(host.scene),
          guide_(make_guide(host.scene, settings_)),
          photons_(make_schedule()),
          importance_(make_importance()),
          photon_pass_(host.scene, settings_, guide_.get(), importance_ ? &*importance_ : nullptr),
          radius_policy_(make_radii()) {
        statistics_.memory_bound_bytes = memory_bound(
            host.scene, needs_, eye_paths_, std::size_t{host.film.width()} * host.film.height());
        if (photons_.adapts()) noise_.emplace(host.film.width(), host.film.height());
        if (settings.debug_layers) add_debug_layers();
        refuse_powers();
        log_start(settings);
    }

    PassReport render_pass(std::uint64_t pass) {
        const float time = pass_time(pass);
        PassReport report;
        SearchRadii radii;
        report.eye_paths = trace_eye_paths(pass, time);
        if (pass == 0) warn_of_lost_precision(image_, host_.log);
        const std::uint64_t eye_rays = report.eye_paths ? image_.rays : 0;
        const bool any_points = !image_.visible_points.empty();
        if (pass == 0 && any_points) choose_photon_way(time);
        const PhotonPassTotals before = photon_pass_.totals();
        const PassPhotons photons = photons_.next();
        if (needs_.photons && (any_points || !image_.beams.empty())) {
            if (any_points) radii = radius_policy_->before_pass(pass, photons, image_);
            report.radius = radii.mean;
            report.photon_paths = photons.paths;
            photon_pass_.shoot(pass, photons, time, image_, radii, refusals_, flux_);
        } else {
            flux_.reset(image_.visible_points.size(), image_.groups);
            if (needs_.photons) skip_log_.no_visible_points(freezes_eye_pass(settings_.mode));
        }
        add_to_film(report.photon_paths, radii, photons.weight);
        if (report.photon_paths && any_points) radius_policy_->after_pass(flux_);
        const PhotonPassTotals& after = photon_pass_.totals();
        report.rays = eye_rays + after.counts.rays - before.counts.rays;
        if (report.eye_paths) {
            direct_light_.learn(image_.light_samples, light_samples_due(report.eye_paths),
                                pass + 1);
        }
        learn_from_pass(report, pass_work(report.eye_paths, eye_rays, before, after));
        count(report, eye_rays);
        skip_log_.after_pass(photon_pass_.adaptive(), after.counts);
        return report;
    }

    EngineStatistics statistics() const {
        EngineStatistics s = statistics_;
        const PhotonPassTotals& photons = photon_pass_.totals();
        s.photon_paths = photons.counts.paths;
        s.photon_rays = photons.counts.rays;
        s.landings = photons.counts.landings;
        s.split_off = photons.counts.split_off;
        s.bounces = photons.counts.bounces;
        s.guided_bounces = photons.counts.guided_bounces;
        s.gathered = photons.gathered;
        s.photons_per_pass = photons_.next().paths;
        s.photon_seconds = photons.photon_seconds;
        s.gather_seconds = photons.gather_seconds;
        s.guide_seconds = photons.guide_seconds;
        if (const PhotonChains* chains = photon_pass_.chains()) {
            s.measured_paths = chains->totals().measured;
            s.visible_paths = chains->totals().visible;
            s.mutation_size = chains->mutation_size();
        }
        if (guide_) {
            s.guide_nodes = guide_->statistics().nodes;
            s.guide_bytes = guide_->statistics().memory_bytes;
        }
        if (const AdaptiveGuide* adaptive = photon_pass_.adaptive()) {
            s.guide_nodes = adaptive->node_count();
            s.guide_bytes = adaptive->memory_bytes();
            s.emission_gain = adaptive->emission_guide().gain();
            s.survival_gain = adaptive->survival_gain();
            if (const BounceGuide* bounces = adaptive->bounces()) {
                s.bounce_gain = bounces->tables().gain();
                s.bounce_tables = bounces->tables().tables_in_use();
            }
            s.score_times_cost = adaptive->score_times_cost();
            s.pruned_paths = photons.counts.pruned;
            s.pruned_emission = adaptive->emission_guide().starved_share(kPrunedDensity);
        }
        s.memory_bytes = memory_bytes();
        s.refused = refusals_.by_origin();
        return s;
    }

    void state(StateArchive& archive) {
        state_of_identity(archive, host_, settings_, eye_paths_);
        for (std::uint64_t* count :
             {&statistics_.passes, &statistics_.eye_paths, &statistics_.eye_rays})
            archive.value(*count);
        archive.amount(statistics_.radius);
        refusals_.state(archive);
        skip_log_.state(archive);
        state_of_way(archive);
        photons_.state(archive);
        direct_light_.state(archive);
        if (guide_) guide_->state(archive);
        if (importance_) importance_->state(archive);
        if (noise_) noise_->state(archive);
        photon_pass_.state(archive);
        if (archive.restoring() && statistics_.passes > 0) trace_frozen_again();
        radius_policy_->state(archive, image_);
        if (layers_) layers_->state(archive);
        photon_pass_.state_of_seconds(archive);
        archive.amount(statistics_.eye_seconds);
        archive.amount(statistics_.plan_seconds);
    }

  private:
    void state_of_way(StateArchive& archive) {
        archive.value(photon_way_);
        const bool asked_for = settings_.guide == GuideKind::Adaptive && settings_.guide_scout &&
                               (photon_way_ != PhotonWay::Chains || settings_.guide_chains);
        StateArchive::check(
            photon_way_ <= PhotonWay::Chains && (photon_way_ == PhotonWay::Guided || asked_for),
            "a guide left out that was not asked for");
        if (archive.restoring()) take_way(photon_way_);
    }

    /// Their Bsdfs are the host's, which only it can make.
    void trace_frozen_again() {
        if (!freezes_eye_pass(settings_.mode)) return;
        Refusals counted_before(host_.scene);
        trace_eyes(0, pass_time(0), counted_before);
    }

    void add_debug_layers() {
        layers_.emplace(host_.film, guide_.get());
        statistics_.memory_bound_bytes +=
            DebugLayers::memory_bound_bytes(std::size_t{host_.film.width()} * host_.film.height(),
                                            eye_paths_, guide_ ? settings_.max_nodes : 0);
    }

    /// Lights that nothing is ever asked of, as what they say of their power is none.
    void refuse_powers() {
        const auto lights = host_.scene.lights();
        for (LightIndex i = 0; i < lights.size(); ++i)
            refusals_.accept_density(lights[i]->power(), refusals_.of_light(i));
    }

    void log_start(const Settings& asked_for) {
        host_.log.info("engine: " + describe(asked_for));
        host_.log.info("engine memory: at most " +
                       std::to_string((statistics_.memory_bound_bytes >> 20) + 1) + " MiB");
        skip_log_.start(needs_);
    }

    /// Whether a guide learns that lessens the weight of the first photon paths.
    bool learns() const {
        return settings_.guide == GuideKind::Adaptive && photon_way_ == PhotonWay::Guided;
    }

    /// Before the first photon path. In media scores know surfaces alone, and so do the counts.
    void choose_photon_way(float time) {
        if (!needs_.photons || !learns() || !settings_.guide_scout || host_.scene.media()) return;
        const Stopwatch watch(statistics_.plan_seconds);
        const double radius = initial_radius(settings_, image_, smallest_radius(host_.scene));
        const SeenPaths seen = scout_photons(host_.scene, settings_, time, image_, float(radius));
        take_way(photon_way(settings_, seen));
        if (photon_way_ != PhotonWay::Guided) skip_log_.left_out_guide(photon_way_, seen);
    }

    void take_way(PhotonWay way) {
        photon_way_ = way;
        if (way == PhotonWay::Guided) return;
        photon_pass_.leave_out_guide(way == PhotonWay::Chains);
        photons_ = make_schedule();
        importance_ = make_importance();
        radius_policy_ = make_radii();
        // Landings of chains come in clusters, whose noise their squares do not tell.
        if (way == PhotonWay::Chains) noise_.reset();
    }

    PhotonSchedule make_schedule() const {
        return {settings_, eye_paths_, needs_.photons, learns(), photon_way_ == PhotonWay::Chains};
    }

    std::unique_ptr<RadiusPolicy> make_radii() const {
        Settings radii = settings_;
        const bool automatic = !(radii.start_radius > 0);
        if (automatic && photon_way_ == PhotonWay::Chains) {
            radii.start_radius = kChainAutomaticRadius;
        }
        return make_radius_policy(radii, host_.scene, host_.film.width(), host_.film.height());
    }

    std::optional<PixelImportance> make_importance() const {
        const bool measures_noise = photons_.adapts() && photon_way_ != PhotonWay::Chains;
        if (!learns() && !measures_noise && !(guide_ && guide_->needs_scores())) return {};
        return PixelImportance(host_.film.width(), host_.film.height());
    }

    /// Eye paths count alike in all passes; a pass that shot no photons has black ones.
    void add_to_film(std::uint64_t photon_paths, const SearchRadii& radii, double photon_weight) {
        if (photon_paths) {
            photon_pass_.estimate(image_, flux_, radii, photon_paths, refusals_, photon_radiance_,
                                  noise_ ? &photon_variances_ : nullptr);
        } else if (needs_.photons) {
            photon_radiance_.assign(image_.radiance.size(), Rgb{});
        }
        const FilmPass pass{.positions = image_.positions,
                            .groups = image_.groups,
                            .eye = image_.radiance,
                            .photons = photon_radiance_,
                            .photon_weight = photon_weight};
        host_.film.add_pass(pass);
        if (layers_) layers_->add_pass(image_, flux_, radii, pass, photon_pass_.bounces());
    }

    /// The pass's image is known.
    void learn_from_pass(const PassReport& report, const PassWork& work) {
        PassNoise noise;
        if (importance_ && report.photon_paths) {
            const Stopwatch watch(statistics_.plan_seconds);
            pixel_luminances(image_, photon_radiance_, host_.film.width(), host_.film.height(),
                             seen_);
            if (noise_) {
                noise =
                    noise_->add_pass(seen_, photon_variances_, report.photon_paths, *importance_);
            }
            importance_->add_pass(seen_);
        }
        photons_.end_pass(work, noise);
    }

    /// One moment of the shutter interval for all paths of a pass; frozen visible points stay where
    /// their surfaces were, so that all photons meet the scene of that moment.
    float pass_time(std::uint64_t pass) const {
        if (freezes_eye_pass(settings_.mode)) pass = 0;
        RandomStream random(settings_.seed, pass, 0, RandomDomain::Time);
        const float open = host_.camera.shutter_open();
        return open + (host_.camera.shutter_close() - open) * random.next();
    }

    /// Returns the eye paths traced: none in later passes if the first is frozen.
    std::uint32_t trace_eye_paths(std::uint64_t pass, float time) {
        if (freezes_eye_pass(settings_.mode) && traced_eye_pass_) return 0;
        const Stopwatch watch(statistics_.eye_seconds);
        trace_eyes(pass, time, refusals_);
        return eye_paths_;
    }

    void trace_eyes(std::uint64_t pass, float time, Refusals& refusals) {
        const EyePassInput input{host_.scene,         host_.camera, host_.sampler,
                                 direct_light_,       settings_,    host_.film.width(),
                                 host_.film.height(), eye_paths_,   needs_.photons};
        trace_eye_pass(input, pass, time, refusals, image_);
        traced_eye_pass_ = true;
    }

    void count(const PassReport& report, std::uint64_t eye_rays) {
        ++statistics_.passes;
        statistics_.eye_paths += report.eye_paths;
        statistics_.eye_rays += eye_rays;
        statistics_.radius = report.radius;
    }

    std::size_t memory_bytes() const {
        return image_.memory_bytes() + flux_.memory_bytes() +
               photon_radiance_.capacity() * sizeof(Rgb) +
               photon_variances_.capacity() * sizeof(float) +
               seen_.capacity() * sizeof(PixelLuminance) + photon_pass_.memory_bytes() +
               radius_policy_->memory_bytes() + direct_light_.memory_bytes() +
               (guide_ ? guide_->statistics().memory_bytes : 0) +
               (importance_ ? importance_->memory_bytes() : 0) +
               (noise_ ? noise_->memory_bytes() : 0) + (layers_ ? layers_->memory_bytes() : 0);
    }

    Host host_;
    Needs needs_;
    SkipLog skip_log_;
    const Settings& settings_;  // without what needs_ skips
    std::uint32_t eye_paths_;
    DirectLight direct_light_;
    Refusals refusals_;
    std::unique_ptr<Guide> guide_;
    PhotonWay photon_way_ = PhotonWay::Guided;  // if the guide is the adaptive one
    PhotonSchedule photons_;
    std::optional<PixelImportance> importance_;  // if something steers by it
    std::optional<PassNoiseMeter> noise_;        // if the photons per pass follow it
    PhotonPass photon_pass_;
    std::unique_ptr<RadiusPolicy> radius_policy_;
    EyeImage image_;
    PhotonFlux flux_;
    std::vector<Rgb> photon_radiance_;     // [eye path * groups + group]; empty if none are needed
    std::vector<float> photon_variances_;  // [eye path]: of the luminance of that; with noise_
    std::vector<PixelLuminance> seen_;     // in the last pass that something steers by
    std::optional<DebugLayers> layers_;
    EngineStatistics statistics_;
    bool traced_eye_pass_ = false;
};

Engine::Engine(const Host& host, const Settings& settings) {
    validate(settings);
    state_ = std::make_unique<State>(host, settings);
}
Engine::~Engine() = default;
PassReport Engine::render_pass(std::uint64_t pass) {
    return state_->render_pass(pass);
}
EngineStatistics Engine::statistics() const {
    return state_->statistics();
}
void Engine::state(StateArchive& archive) {
    state_->state(archive);
}

}  // namespace aips
