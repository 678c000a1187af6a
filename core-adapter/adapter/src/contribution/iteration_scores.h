// What an iteration's photons contributed to the image, for the guides that learn from it.
#pragma once

#include "contribution/photon_score.h"
#include "contribution/pixel_importance.h"

namespace aips {

class IterationScores {
  public:
    /// `importance` outlives this.
    explicit IterationScores(const PixelImportance& importance) : importance_(importance) {}

    /// A pass with these visible points begins; all but the positions stay until it ends. Returns
    /// the mean weight, by which those in the scores were divided (PixelImportance::weigh).
    double begin_pass(const EyeImage& image, std::span<const Vec3> positions,
                      const GatherRadii& radii);
    /// One score for each photon, valid until the next call.
    std::span<const double> of(std::span<const Photon> photons);

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() with at most so many photons in an iteration.
    static std::size_t memory_bound_bytes(std::size_t eye_paths, std::size_t photons);

  private:
    const PixelImportance& importance_;
    PhotonScore score_;
    std::vector<float> weights_;  // [visible point]
    std::vector<double> scores_;  // of the last call
};

}  // namespace aips
