// Piecewise-constant density over the unit square.
#pragma once

#include <cstddef>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Density in proportion to a grid of weights, by inversion of row and in-row sums; monotone, so
/// that stratified coordinates stay stratified (Pharr et al. 2016, section 13.6.7).
class Piecewise2D {
  public:
    Piecewise2D() = default;
    /// `weights` row by row, `width` a row; finite and >= 0.
    Piecewise2D(std::size_t width, std::size_t height, const std::vector<float>& weights);

    /// False if all weights are zero: then nothing can be sampled.
    bool positive() const { return total_ > 0; }
    /// Draws a point of the unit square; `density` is relative to its area.
    Vec2 sample(const Vec2& u, float& density) const;
    float density(const Vec2& p) const;
    /// Inverse of sample, in [0, 1)^2; false where nothing is drawn.
    bool coordinates(const Vec2& p, Vec2& u) const;

  private:
    std::size_t width_ = 0, height_ = 0;
    std::vector<float> densities_;  ///< of the cells
    std::vector<float> rows_;       ///< CDF over rows, height_ + 1 values
    std::vector<float> columns_;    ///< CDF within each row, width_ + 1 values a row
    double total_ = 0;
};

}  // namespace lxs
