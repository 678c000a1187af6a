// One radius for all visible points, known before any photon is shot.
#pragma once

#include "radius_policy.h"

namespace aips {

/// Radius after so many photon paths of a render that started with `initial` (Knaus & Zwicker
/// 2011).
float scheduled_radius(const Settings& settings, double initial, double paths_shot,
                       double smallest);

/// mode=progressive: a function of the photon paths shot before the pass (Knaus & Zwicker 2011).
/// mode=photonmap: the same in all passes.
class ScheduledRadius final : public RadiusPolicy {
  public:
    ScheduledRadius(const Settings& settings, const Scene& scene)
        : settings_(settings), smallest_(smallest_radius(scene)) {}

    SearchRadii before_pass(std::uint64_t pass, const PassPhotons& photons,
                            const EyeImage& image) override;
    void after_pass(const PhotonFlux& /*flux*/) override {}
    void state(StateArchive& archive, const EyeImage& /*image*/) override {
        state_of_initial_radius(archive, initial_, smallest_);
    }
    std::size_t memory_bytes() const override { return 0; }

  private:
    Settings settings_;
    double smallest_;
    double initial_ = 0;  // from the first visible points' pixel footprints
};

}  // namespace aips
