// Piecewise-constant density over the unit square.
#pragma once

#include <cstddef>
#include <vector>

#include "cell_choice.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// Density in proportion to a grid of weights, but for rounding (CellChoice), which is part of what
/// it states.
class Piecewise2D {
  public:
    Piecewise2D() = default;
    /// `weights` row by row, `width` a row; finite and >= 0.
    Piecewise2D(std::size_t width, std::size_t height, const std::vector<float>& weights)
        : cells_(width, height, weights) {}

    /// False if all weights are zero: then nothing can be sampled.
    bool positive() const { return cells_.positive(); }
    /// Draws a point of the unit square; `density` is relative to its area.
    Vec2 sample(const Vec2& u, float& density) const;
    float density(const Vec2& p) const;
    /// Inverse of sample, in [0, 1)^2; false where nothing is drawn.
    bool coordinates(const Vec2& p, Vec2& u) const;

  private:
    /// Cells in the unit square.
    float count() const {
        return static_cast<float>(cells_.width()) * static_cast<float>(cells_.height());
    }

    CellChoice cells_;
};

}  // namespace lxs
