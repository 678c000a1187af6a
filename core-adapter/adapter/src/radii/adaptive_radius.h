// radius=adaptive in mode=progressive: a radius per visible point, from what earlier passes told of
// noise and bias around its pixel.
#pragma once

#include <optional>

#include "radii/blur_map.h"
#include "radii/curvature_map.h"
#include "radii/radius_policy.h"

namespace aips {

class AdaptiveRadius final : public RadiusPolicy {
  public:
    /// The film has width x height pixels.
    AdaptiveRadius(const Settings& settings, const Scene& scene, std::uint32_t width,
                   std::uint32_t height);

    GatherRadii before_pass(const PassPhotons& photons, const EyeImage& image) override;
    void after_pass(const PhotonFlux& flux) override;
    void state(StateArchive& archive, const EyeImage& image) override;
    std::size_t memory_bytes() const override;
    /// Upper bound of memory_bytes() for so many visible points; `narrows`: whether blur narrows
    /// radii.
    static std::size_t memory_bound_bytes(std::size_t pixels, std::size_t visible_points,
                                          bool narrows);

  private:
    void renew();
    void learn_blur(const PhotonFlux& flux);

    Settings settings_;
    RadiusFloor floor_;
    double initial_ = 0;                 // from the first visible points' pixel footprints
    double unit_ = 0;                    // probe radius of the first pass
    double probe_radius_ = 0;            // of this pass
    double pass_paths_ = 0;              // photon paths of this pass
    std::uint64_t passes_ = 0;           // that shot photons, before the next
    CurvatureMap map_;                   // in lengths of unit_
    std::optional<BlurMap> blur_;        // if blur narrows radii
    std::vector<float> of_one_path_;     // [pixel]: optimal radius in unit_ if one path is shot
    std::vector<std::uint32_t> pixels_;  // [visible point]
    std::vector<float> radii_;           // [visible point]
    std::vector<std::uint32_t> probes_;  // visible points
};

}  // namespace aips
