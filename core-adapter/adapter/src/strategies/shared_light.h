// Light that eye paths carry together with photons: what continued eye paths brought is joined to
// what photons did, and both tell the planner how the next passes may share it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "aips/adapter/engine.h"
#include "contribution/own_light_noise.h"
#include "contribution/photon_square.h"
#include "contribution/pixel_importance.h"
#include "estimate/gather.h"
#include "eye/eye_shares.h"
#include "plan/pass_plan.h"

namespace aips {

/// A pass under way that shot photons.
struct ShotPass {
    std::uint64_t number = 0;
    std::uint64_t photon_paths = 0;
};

class SharedLight {
  public:
    /// For a film of so many pixels.
    SharedLight(const Scene& scene, const Settings& settings, std::uint32_t width,
                std::uint32_t height)
        : shares_(scene.bounds()),
          own_noise_(width, height),
          photon_square_(width, height),
          width_(width),
          height_(height) {
        if (!settings.caustics_on_gloss || !(scene.facts().lobes & kSpecular)) return;
        shares_.gloss.emplace(scene.bounds());
        shares_.gloss_needs_photons = !std::ranges::all_of(
            scene.lights(), [&](const Light* light) { return eye_paths_meet(*light, settings); });
    }

    const EyeShares& shares() const { return shares_; }

    /// Of a pass: `radiance` is what its photons brought to each eye path, made of `flux`, without
    /// the eye's share; that is added. Learns from both where something is known of the image.
    void join(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
              const GatherRadii& radii, const PixelImportance& importance, std::span<Rgb> radiance);
    /// Of a pass that shot no photons, in its turn: adds the eye's share.
    void go_on_alone(const EyeImage& image, std::span<Rgb> radiance);

    /// Before the eye paths of a pass, one of so many of which one shoots photons: whether it does.
    void begin_pass(std::uint32_t turns, bool shoots) {
        shares_.turns = turns;
        shares_.shoots = shoots;
    }

    /// Rays that went on from visible points in the last pass that shot.
    double continued_rays() const { return rays_; }
    /// Adds what passes told of shared light since the last call.
    void add_to(PlanFacts& facts, const PixelImportance& importance);
    /// What the plan that was made of it says for pass `pass` and those that follow.
    void take(const PassPlan& plan, std::uint64_t pass);

    void add_to(EngineStatistics& statistics) const;

    /// Saves what later passes go on from, or restores it.
    void state(StateArchive& archive);
    /// The same for another render, from before the first pass on: shares stay until the first
    /// decision, what they rest on fades.
    void learned(LearnedParts& parts);
    std::size_t memory_bytes() const {
        return shares_.table.memory_bytes() + (shares_.gloss ? shares_.gloss->memory_bytes() : 0) +
               own_noise_.memory_bytes() + photon_square_.memory_bytes();
    }

  private:
    void add_eye_share(const EyeImage& image, std::span<Rgb> radiance) const;
    void learn(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
               const GatherRadii& radii, const PixelImportance& importance);
    void learn_gloss(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
                     const GatherRadii& radii, const PixelImportance& importance);
    void set_any();

    EyeShares shares_;
    OwnLightNoise own_noise_;
    PhotonSquare photon_square_;
    std::uint32_t width_, height_;
    double rays_ = 0;              // that went on from visible points
    std::uint64_t continued_ = 0;  // eye paths that went on, of all passes
    double eye_part_ = 0;          // of what is shared, by the last plan
};

}  // namespace aips
