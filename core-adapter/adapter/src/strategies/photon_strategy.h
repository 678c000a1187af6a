// Light by photons: what a plan says of them, put together. Photon paths are shot onto the visible
// points of a pass and gathered there; noise, importance of pixels, radii and guides learn from it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contribution/pass_noise.h"
#include "contribution/pixel_importance.h"
#include "contribution/pixel_luminance.h"
#include "estimate/edge_correction.h"
#include "estimate/pixel_estimate.h"
#include "layers/debug_layers.h"
#include "photons/photon_pass.h"
#include "plan/pass_planner.h"
#include "plan/photon_schedule.h"
#include "plan/skip_log.h"
#include "radii/radius_policy.h"
#include "strategies/light_strategy.h"
#include "strategies/shared_light.h"

namespace aips {

class PhotonStrategy : public LightStrategy {
  public:
    /// The host's parts and `plan` outlive it.
    PhotonStrategy(const Host& host, Plan& plan, std::uint32_t eye_paths);

    const EyeShares* eye_shares() const override { return shared_ ? &shared_->shares() : nullptr; }
    const DiscGaps* disc_gaps() const override { return edges_ ? &*edges_ : nullptr; }
    std::uint64_t begin_pass(const ComingPass& /*pass*/) override {
        if (shared_) shared_->begin_pass(schedule_.turns(), schedule_.shoots());
        return 0;
    }
    CarriedLight carry(const StrategyPass& pass, PassReport& report) override;
    void end_pass(const StrategyPass& pass, const FilmPass& film_pass) override;
    void state(StateArchive& archive, const EyeImage& image) override;
    void state_of_seconds(StateArchive& archive) override;
    void learned(LearnedParts& parts) override;
    void add_to(EngineStatistics& statistics) const override;
    std::size_t memory_bytes() const override;
    std::size_t memory_bound_bytes() const override;

  private:
    void run_pilot_pass(const StrategyPass& pass);
    void take_way(PhotonWay way);
    PhotonSchedule make_schedule() const;
    std::unique_ptr<RadiusPolicy> make_radii() const;
    std::optional<PixelImportance> make_importance() const;
    std::unique_ptr<PassGuide> make_pass_guide() const;
    std::unique_ptr<PhotonSource> make_source() const;
    void shoot(const StrategyPass& pass, const PassPhotons& photons, PassReport& report);
    void join_eye_share(const StrategyPass& pass, const PassPhotons& photons);
    void leave_out_photons(const EyeImage& image);
    const std::vector<Rgb>& counted() const;
    void show_layers(const EyeImage& image, const FilmPass& film_pass);
    void show_bias(const EyeImage& image, const FilmPass& film_pass);
    void plan_from(std::uint64_t pass);
    PassNoise learn_noise(const EyeImage& image);
    bool plans_passes() const { return plan_.measures_noise() || settings_.continue_eye_paths; }
    std::size_t pixels() const { return std::size_t{film_.width()} * film_.height(); }

    const Scene& scene_;
    Film& film_;
    Plan& plan_;
    const Settings& settings_;  // without what the plan skips
    std::uint32_t eye_paths_;
    SkipLog skip_log_;
    DiscreteDistribution light_choice_;  // by power
    std::unique_ptr<Guide> guide_;       // guide=paper
    PhotonSchedule schedule_;
    std::optional<PixelImportance> importance_;  // if something steers by it
    std::optional<PassNoiseMeter> noise_;        // if passes are planned
    PassPlanner planner_;
    std::optional<SharedLight> shared_;  // if eye paths go on from visible points
    PhotonPass photon_pass_;
    std::unique_ptr<RadiusPolicy> radius_policy_;
    std::optional<EdgeCorrection> edges_;       // if gather discs are asked for edges
    std::optional<PhotonOcclusion> occlusion_;  // if photons are asked for what separates them
    GatherRadii radii_;                         // of the last pass
    std::uint32_t shot_ = 0;                    // photon paths in it
    bool in_turn_ = true;                       // whether it was one that shoots
    PhotonFlux flux_;
    PhotonPassTotals before_;    // the last pass
    std::vector<Rgb> radiance_;  // [eye path * groups + group]; empty if none is needed
    std::vector<Rgb> counted_;   // that with photons as they count; where some passes have none
    std::vector<Rgb> parts_;     // [eye path * kImageParts + part]; empty if not wanted
    DiscEstimates discs_;        // if the film wants their bias
    PhotonVariances variances_;  // of the luminance of that, if they are asked for
    std::vector<PixelLuminance> seen_;  // in the last pass that something steers by
    std::optional<DebugLayers> layers_;
    double plan_seconds_ = 0, edge_seconds_ = 0;
};

}  // namespace aips
