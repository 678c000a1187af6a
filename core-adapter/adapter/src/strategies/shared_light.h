// Light that eye paths carry together with photons: what continued eye paths brought is joined to
// what photons did, and both tell how the next passes share it.
#pragma once

#include <cstdint>
#include <optional>

#include "estimate/gather.h"
#include "eye/eye_shares.h"
#include "plan/pass_work.h"
#include "plan/share_plan.h"
#include "worth/own_light_noise.h"
#include "worth/pass_noise.h"
#include "worth/photon_square.h"
#include "worth/pixel_importance.h"

namespace aips {

/// A pass that has ended.
struct SharedPass {
    std::uint64_t number = 0;
    PassWork work;  ///< the eye's with that of continued paths
    PassNoise noise;
    std::uint64_t photon_paths = 0;
    std::uint32_t turns = 1;   ///< passes of which one shoots
    bool independent = true;   ///< squares of single photons tell their variance
    double squared_error = 1;  ///< of photons, their bias included, over their variance
};

/// A pass under way that shot photons.
struct ShotPass {
    std::uint64_t number = 0;
    std::uint64_t photon_paths = 0;
};

class SharedLight {
  public:
    /// For a film of so many pixels and passes of so many eye paths.
    SharedLight(const Scene& scene, std::uint32_t width, std::uint32_t height,
                std::uint32_t eye_paths)
        : shares_(scene.bounds()),
          own_noise_(width, height),
          photon_square_(width, height),
          width_(width),
          height_(height),
          eye_paths_(eye_paths) {}

    const EyeShares& shares() const { return shares_; }

    /// Of a pass: `radiance` is what its photons brought to each eye path, made of `flux`, without
    /// the eye's share; that is added. Learns from both where something is known of the image.
    void join(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
              const PixelImportance& importance, std::span<Rgb> radiance);
    /// Of a pass that shot no photons, in its turn: adds the eye's share.
    void go_on_alone(const EyeImage& image, std::span<Rgb> radiance);

    /// Before the eye paths of a pass, one of so many of which one shoots photons: whether it does.
    void begin_pass(std::uint32_t turns, bool shoots) {
        shares_.turns = turns;
        shares_.shoots = shoots;
    }

    /// A pass has ended, `shot` if it had photons. Before passes that are fixed it is decided anew
    /// who carries what; the plan then tells how many photon paths, within `limits`, go with it.
    std::optional<SharePlan> end_pass(const SharedPass& pass, bool shot,
                                      const PixelImportance& importance,
                                      const PhotonLimits& limits);

    void add_to(EngineStatistics& statistics) const;

    /// Saves what later passes go on from, or restores it.
    void state(StateArchive& archive);
    /// The same for another render, from before the first pass on: shares stay until the first
    /// decision, what they rest on fades.
    void learned(LearnedParts& parts);
    std::size_t memory_bytes() const {
        return shares_.table.memory_bytes() + own_noise_.memory_bytes() +
               photon_square_.memory_bytes();
    }

  private:
    void add_eye_share(const EyeImage& image, std::span<Rgb> radiance) const;
    void learn(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
               const PixelImportance& importance, std::span<const Rgb> radiance);
    void set_any();
    void count(const SharedPass& pass);
    SharePlan decide(const SharedPass& pass, const PixelImportance& importance,
                     const PhotonLimits& limits);

    /// Sums since the last decision.
    struct Sums {
        double passes = 0, points = 0;
        double eye_cost = 0, photon_cost = 0, photon_paths = 0;
        double variance = 0, noisy_passes = 0;
    };

    EyeShares shares_;
    OwnLightNoise own_noise_;
    PhotonSquare photon_square_;
    std::uint32_t width_, height_, eye_paths_;
    // Visible points, and rays that went on from them, of a pass that is under way.
    double points_ = 0, rays_ = 0;
    std::uint64_t continued_ = 0;  // eye paths that went on, of all passes
    double eye_part_ = 0;          // of what is shared, by the last decision
    Sums sums_;
};

}  // namespace aips
