// Choice among the cells of a grid, with probabilities that are exactly those drawn.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// A cell, and where in it.
struct DrawnCell {
    std::size_t row = 0, column = 0;
    Vec2 share{0.0f};       ///< (along the row, along the column), uniform in [0, 1)^2
    float probability = 0;  ///< of the cell, > 0
};

/// Chooses the row by one coordinate and the cell in it by the other, by inversion: monotone, so
/// that stratified coordinates stay stratified (Pharr et al. 2016, section 13.6.7), and a million
/// cells leave 14 bits of either coordinate for the place in one. Probabilities are rounded to
/// multiples of 2^-24 in the row and of it; every positive weight keeps one.
class CellChoice {
  public:
    CellChoice() = default;
    /// `weights` row by row, `width` a row, of `height` rows; the last row may lack cells, which
    /// weigh nothing. Finite and >= 0.
    CellChoice(std::size_t width, std::size_t height, std::span<const float> weights);

    /// False if all weights are zero: then nothing can be drawn.
    bool positive() const { return total_ > 0; }
    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    /// Draws by u in [0, 1)^2; must be positive().
    DrawnCell draw(const Vec2& u) const;
    /// With which draw() gives the cell.
    float probability(std::size_t row, std::size_t column) const {
        const float* cell = &columns_[row * (width_ + 1) + column];
        return (rows_[row + 1] - rows_[row]) * (cell[1] - cell[0]);
    }
    /// Inverse of draw, in [0, 1)^2, for a share in [0, 1]^2; false if the cell is never drawn.
    bool coordinates(std::size_t row, std::size_t column, const Vec2& share, Vec2& u) const;

  private:
    std::size_t width_ = 0, height_ = 0;
    std::vector<float> rows_;     ///< CDF over rows, height_ + 1 values
    std::vector<float> columns_;  ///< CDF within each row, width_ + 1 values a row
    double total_ = 0;
};

}  // namespace lxs
