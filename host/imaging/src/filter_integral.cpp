// Summed-area table of a pixel filter.
#include "filter_integral.h"

#include <algorithm>

namespace lxs {
namespace {

/// The cell that holds a distance from the centre, and how far into it the distance reaches.
struct Place {
    std::size_t cell;
    double share;  ///< in [0, 1]

    Place(double distance, double radius, std::size_t per_pixel, std::size_t cells) {
        const double at = std::min(distance, radius) * static_cast<double>(per_pixel);
        cell = std::min(static_cast<std::size_t>(at), cells - 1);
        share = at - static_cast<double>(cell);
    }
};

}  // namespace

FilterIntegral::FilterIntegral(const PixelFilter& filter)
    : radius_x_(filter.radius_x()),
      radius_y_(filter.radius_y()),
      columns_(filter.columns()),
      rows_(filter.rows()),
      columns_per_pixel_(filter.columns_per_pixel()),
      rows_per_pixel_(filter.rows_per_pixel()),
      sums_((columns_ + 1) * (rows_ + 1)) {
    const double area =
        1 / (static_cast<double>(columns_per_pixel_) * static_cast<double>(rows_per_pixel_));
    const std::size_t corners = columns_ + 1;
    for (std::size_t row = 1; row <= rows_; ++row) {
        double along_row = 0;
        for (std::size_t column = 1; column <= columns_; ++column) {
            along_row += area * filter.cell(column - 1, row - 1);
            sums_[row * corners + column] = sums_[(row - 1) * corners + column] + along_row;
        }
    }
}

double FilterIntegral::quadrant(double x, double y) const {
    const Place column(x, radius_x_, columns_per_pixel_, columns_);
    const Place row(y, radius_y_, rows_per_pixel_, rows_);
    const double* corner = &sums_[row.cell * (columns_ + 1) + column.cell];
    const double above = corner[0] + column.share * (corner[1] - corner[0]);
    const double* below = corner + columns_ + 1;
    return above + row.share * (below[0] + column.share * (below[1] - below[0]) - above);
}

double FilterIntegral::over(double left, double right, double up, double down) const {
    return quadrant(left, up) + quadrant(right, up) + quadrant(left, down) + quadrant(right, down);
}

}  // namespace lxs
