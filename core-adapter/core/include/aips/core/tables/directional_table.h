// Piecewise constant densities over the unit square: tables of directions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aips/core/base/vector.h"

namespace aips {

/// A point of the square and the density (per unit area of the square) with which it was drawn.
struct SquareSample {
    Vec2 point;     ///< in [0, 1)^2
    float pdf = 0;  ///< > 0
};

/// What a table takes a weight for: NaN and negative ones are zero, infinite ones FLT_MAX.
float sanitized_weight(float weight);

/// Row-major number of the cell that holds a point of [0, 1)^2 (outside: of the nearest cell).
std::size_t cell_index(Vec2 point, int resolution);

/// n x n cells over the unit square, each of constant density: the discrete adaptive CDF. Rows, and
/// cells within a row, have probabilities that are multiples of 2^-24 (zero weights zero, others at
/// least 2^-24), so that random numbers of 24 bits meet pdf() exactly.
class DirectionalTable {
  public:
    /// Uniform, `resolution` in [1, 2048] cells a side; throws std::invalid_argument.
    explicit DirectionalTable(int resolution = 8);

    /// Takes weights[y * n + x] for the cell [x, x + 1) / n times [y, y + 1) / n, after
    /// sanitized_weight(); uniform if all are zero. Throws std::invalid_argument
    /// unless there are n * n.
    void build(std::span<const float> weights);

    /// Draws a point by u in [0, 1)^2. Continuous in u within a cell.
    SquareSample sample(Vec2 u) const;
    /// Exact density of sample() at a point of [0, 1)^2 (outside: of the nearest cell).
    float pdf(Vec2 point) const;

    int resolution() const { return resolution_; }
    /// Of a table with so many cells a side.
    static std::size_t memory_bytes(int resolution);

  private:
    int resolution_;
    std::vector<float> row_cdf_;   // [y]
    std::vector<float> cell_cdf_;  // [y * n + x]: within row y
};

/// The same over weights that live elsewhere, for products made at a photon's hit (eq. 6): nothing
/// is copied or allocated. Weights must be sanitized (finite, not negative) and may be scaled at
/// will. Cells below 2^-24 of an average cell count as zero, so that no density is tiny but
/// positive.
class CellWeights {
  public:
    /// `weights` as in DirectionalTable::build; must outlive this view.
    CellWeights(std::span<const float> weights, int resolution);

    /// True when all weights are zero and nothing can be drawn.
    bool empty() const { return total_ <= 0; }
    /// Draws a point by u in [0, 1)^2; must not be empty().
    SquareSample sample(Vec2 u) const;
    /// Density of sample() at a point of [0, 1)^2; 0 when empty().
    float pdf(Vec2 point) const;

  private:
    struct Walk {
        std::size_t index;
        double width;
        float within;
    };

    /// Weight of a cell, those below the threshold being zero.
    double kept(std::size_t cell) const {
        const double w = weights_[cell];
        return w >= threshold_ ? w : 0.0;
    }
    double row_sum(std::size_t y) const;

    std::span<const float> weights_;
    int resolution_;
    double threshold_ = 0;
    double total_ = 0;
};

}  // namespace aips
