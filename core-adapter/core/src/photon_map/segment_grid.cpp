// How wide the cells are, and which of them a point is in.
#include "aips/core/photon_map/segment_grid.h"

#include <bit>
#include <limits>

#include "photon_map/constants.h"

namespace aips {
namespace {

/// Rounding of single-precision points and of distances between them stays below this share of the
/// radius and of the greatest coordinate.
constexpr double kRounding = 1e-6;

/// Cells that a query can find its way through: more are not worth it, whatever the points.
constexpr double kMostCellsAnAxis = 1024;

}  // namespace

void SegmentGrid::lay_cells(std::span<const Vec3> points, std::uint32_t thinning) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::array<double, 3> upper{-kNone, -kNone, -kNone};
    lower_ = {kNone, kNone, kNone};
    for (const Vec3 p : points) {
        if (!is_finite(p)) continue;
        const std::array<double, 3> at{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower_[axis] = std::min(lower_[axis], at[axis]);
            upper[axis] = std::max(upper[axis], at[axis]);
        }
    }
    if (lower_[0] > upper[0]) lower_ = upper = {};
    double greatest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        greatest = std::max({greatest, std::abs(lower_[axis]), std::abs(upper[axis])});
    const double extent =
        std::max({upper[0] - lower_[0], upper[1] - lower_[1], upper[2] - lower_[2]});
    radius_ += kRounding * (radius_ + greatest);
    width_ = std::max(radius_ / 2, extent / kMostCellsAnAxis);
    const auto most = double(BucketSort::usual_buckets(points.size()));
    for (;; width_ *= 1.25) {
        double all = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            count_[axis] = int((upper[axis] - lower_[axis]) / width_) + 1;
            all *= count_[axis];
        }
        // A row of cells should hold points enough to be worth the search for its ends.
        const double in_a_row = double(points.size()) / all / thinning * (1 + 2 * radius_ / width_);
        if (all <= most && (in_a_row >= kPointsOfARow || width_ >= 2 * radius_)) break;
    }
    inverse_width_ = 1 / width_;
}

void SegmentGrid::build(std::span<const Vec3> points, float radius, std::uint32_t thinning,
                        const ParallelFor& parallel) {
    radius_ = radius > 1e-30f ? std::min(double(radius), 1e30) : 1e-30;
    lay_cells(points, thinning);
    const auto cell = [&](std::size_t axis, double coordinate) {
        return std::clamp(int((coordinate - lower_[axis]) * inverse_width_), 0, count_[axis] - 1);
    };
    const auto buckets_of = [&](std::size_t first, std::size_t last,
                                std::span<std::uint32_t> buckets) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3 p = points[i];
            buckets[i - first] =
                is_finite(p) ? bucket(cell(0, p.x), cell(1, p.y), cell(2, p.z)) : 0;
        }
    };
    const std::size_t cells =
        std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]);
    sort_.sort(points, std::bit_ceil(cells), buckets_of, parallel);
}

}  // namespace aips
