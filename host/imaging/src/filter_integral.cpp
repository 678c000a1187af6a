// Summed-area table of a pixel filter.
#include "filter_integral.h"

#include <algorithm>

namespace lxs {
namespace {

constexpr std::size_t kCorners = PixelFilter::kCells + 1;

/// The cell that holds a distance from the centre, and how far into it the distance reaches.
struct Place {
    std::size_t cell;
    double share;  ///< in [0, 1]

    Place(double distance, double radius) {
        const double at = std::min(distance / radius, 1.0) * PixelFilter::kCells;
        cell = std::min(static_cast<std::size_t>(at), PixelFilter::kCells - 1);
        share = at - static_cast<double>(cell);
    }
};

}  // namespace

FilterIntegral::FilterIntegral(const PixelFilter& filter)
    : radius_x_(filter.radius_x()), radius_y_(filter.radius_y()), sums_(kCorners * kCorners) {
    const double width = radius_x_ / PixelFilter::kCells, height = radius_y_ / PixelFilter::kCells;
    for (std::size_t row = 1; row < kCorners; ++row) {
        double along_row = 0;
        for (std::size_t column = 1; column < kCorners; ++column) {
            along_row += width * height * filter.cell(column - 1, row - 1);
            sums_[row * kCorners + column] = sums_[(row - 1) * kCorners + column] + along_row;
        }
    }
}

double FilterIntegral::quadrant(double x, double y) const {
    const Place column(x, radius_x_), row(y, radius_y_);
    const double* corner = &sums_[row.cell * kCorners + column.cell];
    const double above = corner[0] + column.share * (corner[1] - corner[0]);
    const double* below = corner + kCorners;
    return above + row.share * (below[0] + column.share * (below[1] - below[0]) - above);
}

double FilterIntegral::over(double left, double right, double up, double down) const {
    return quadrant(left, up) + quadrant(right, up) + quadrant(left, down) + quadrant(right, down);
}

}  // namespace lxs
