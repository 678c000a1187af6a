// What an iteration's landings were worth to the image, for a guide that learns from all of them.
#pragma once

#include "landing_score.h"
#include "pixel_importance.h"

namespace aips {

class IterationScores {
  public:
    /// `importance` outlives this.
    explicit IterationScores(const PixelImportance& importance) : importance_(importance) {}

    /// A pass with these visible points begins; all of it stays until the pass ends.
    void begin_pass(const EyeImage& image, std::span<const Vec3> positions,
                    const SearchRadii& radii);
    /// One score for each landing, valid until the next call.
    std::span<const double> of(std::span<const Landing> landings);

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() with at most so many landings in an iteration.
    static std::size_t memory_bound_bytes(std::size_t eye_paths, std::size_t landings);

  private:
    const PixelImportance& importance_;
    LandingScore score_;
    std::vector<float> weights_;  // [visible point]
    std::vector<double> scores_;  // [landing]
};

}  // namespace aips
