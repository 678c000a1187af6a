// How much of a pixel filter lies on the film.
#pragma once

#include <cstddef>
#include <vector>

#include "pixel_filter.h"

namespace lxs {

/// Integral of a pixel filter over rectangles around its centre, in square pixels: a summed-area
/// table (Crow 1984), exact because the filter is constant within each cell of its own table.
class FilterIntegral {
  public:
    explicit FilterIntegral(const PixelFilter& filter);

    /// Over [-left, right] x [-up, down]; all four >= 0, in pixels.
    double over(double left, double right, double up, double down) const;

  private:
    /// Over [0, x] x [0, y].
    double quadrant(double x, double y) const;

    double radius_x_, radius_y_;
    std::size_t columns_, rows_;
    std::size_t columns_per_pixel_, rows_per_pixel_;
    std::vector<double> sums_;  ///< [row * (columns + 1) + column], up to the corner of each cell
};

}  // namespace lxs
