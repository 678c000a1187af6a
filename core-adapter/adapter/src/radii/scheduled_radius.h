// One radius for all visible points, known before any photon is shot; more only where single
// precision asks for it.
#pragma once

#include "radii/radius_policy.h"

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
        : settings_(settings), floor_(scene) {}

    GatherRadii before_pass(const PassPhotons& photons, const EyeImage& image) override;
    void after_pass(const PhotonFlux& /*flux*/) override {}
    void state(StateArchive& archive, const EyeImage& /*image*/) override {
        state_of_initial_radius(archive, initial_, floor_.least());
    }
    std::size_t memory_bytes() const override { return radii_.capacity() * sizeof(float); }
    /// Upper bound of memory_bytes() for so many visible points.
    static std::size_t memory_bound_bytes(std::size_t visible_points) {
        return visible_points * sizeof(float);
    }

  private:
    Settings settings_;
    RadiusFloor floor_;
    double initial_ = 0;        // from the first visible points' pixel footprints
    std::vector<float> radii_;  // [visible point]: where some are held up by the floor
};

}  // namespace aips
