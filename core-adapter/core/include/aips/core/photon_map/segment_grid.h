// Points in a grid over their bounds: which of them are near a segment.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "aips/core/base/parallel.h"
#include "aips/core/base/vector.h"
#include "aips/core/photon_map/bucket_sort.h"

namespace aips {

/// A segment of a line.
struct Segment {
    Vec3 origin;
    Vec3 direction;  ///< unit
    float length = 0;
};

/// Points in cells half to twice as wide as the distance that is searched. Rows of cells lie along
/// x and are contiguous, so that a query is a few dozen runs of slots. Buffers are reused. Queries
/// are const and may run on many threads.
class SegmentGrid {
  public:
    /// Sorts `points` (fewer than 2^32) for queries within `radius`, which is clamped to [1e-30,
    /// 1e30], that ask one of `thinning` slots. Points that are not finite are left out. The result
    /// is the same for every `parallel`.
    void build(std::span<const Vec3> points, float radius, std::uint32_t thinning,
               const ParallelFor& parallel);

    /// Calls `visit(first, last)` for runs of slots, none twice, in which is every point that lies
    /// within the radius of a place of the segment at right angles to it; and others. The order is
    /// a function of points and segment alone.
    template <class F>
    void for_each_run(const Segment& segment, F&& visit) const {
        if (size() == 0 || !is_finite(segment.origin) || !is_finite(segment.direction)) return;
        const Reach reach(segment, radius_);
        const auto [z_first, z_last] = cells(2, reach.within(2, 0, reach.length));
        for (int z = z_first; z <= z_last; ++z) {
            const Interval layer = slab(2, z);
            const Interval near_layer = reach.near(2, layer, {0, reach.length});
            if (near_layer.empty()) continue;
            const Interval y_range =
                reach.within(1, near_layer.from, near_layer.to).and_also(reach.beside(1, 2, layer));
            const auto [y_first, y_last] = cells(1, y_range);
            for (int y = y_first; y <= y_last; ++y) {
                const Interval row = slab(1, y);
                const Interval near_row = reach.near(1, row, near_layer);
                if (near_row.empty()) continue;
                const Interval x_range = reach.within(0, near_row.from, near_row.to)
                                             .and_also(reach.beside(0, 2, layer))
                                             .and_also(reach.beside(0, 1, row));
                const auto [x_first, x_last] = cells(0, x_range);
                if (x_first > x_last) continue;
                const std::uint32_t first = sort_.first_slot(bucket(x_first, y, z));
                const std::uint32_t last = sort_.first_slot(bucket(x_last, y, z) + 1);
                if (first < last) visit(first, last);
            }
        }
    }

    /// Points that queries can find.
    std::size_t size() const { return sort_.size(); }
    /// [slot]: number of the point among those that were sorted.
    std::span<const std::uint32_t> order() const { return sort_.order(); }
    /// [slot]
    std::span<const Vec3> positions() const { return sort_.positions(); }
    std::size_t memory_bytes() const { return sort_.memory_bytes(); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points) {
        return BucketSort::memory_bound_bytes(max_points);
    }

  private:
    struct Interval {
        double from = 0, to = 0;
        bool empty() const { return !(from <= to); }
        Interval and_also(const Interval& other) const {
            return {std::max(from, other.from), std::min(to, other.to)};
        }
    };

    /// A segment with a radius. Of a point within it, at right angles to the place at t, each
    /// coordinate is within the radius of that place's.
    struct Reach {
        Reach(const Segment& segment, double r)
            : origin{segment.origin.x, segment.origin.y, segment.origin.z},
              direction{segment.direction.x, segment.direction.y, segment.direction.z},
              length(std::clamp(double(segment.length), 0.0, kFarthest)),
              radius(r) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                inverse[axis] = 1 / direction[axis];
            for (std::size_t axis = 0; axis < 2; ++axis) {
                for (std::size_t other = axis + 1; other < 3; ++other) {
                    const double u = direction[axis], d = direction[other];
                    aside[axis + other - 1] =
                        r * std::sqrt(u * u + d * d) * std::abs(inverse[other]);
                }
            }
        }

        double at(int axis, double t) const { return origin[axis] + direction[axis] * t; }
        /// Where points beside [from, to] may be.
        Interval within(int axis, double from, double to) const {
            const double a = at(axis, from), b = at(axis, to);
            return {std::min(a, b) - radius, std::max(a, b) + radius};
        }
        /// Which part of `part` a point between these coordinates may be beside.
        Interval near(int axis, const Interval& slab, const Interval& part) const {
            const double a = slab.from - radius - origin[axis], b = slab.to + radius - origin[axis];
            if (std::abs(direction[axis]) < kParallel) {
                const double drift = kParallel * length;
                return a <= drift && b >= -drift ? part : Interval{1, 0};
            }
            const double from = a * inverse[axis], to = b * inverse[axis];
            return Interval{std::min(from, to), std::max(from, to)}.and_also(part);
        }
        /// Where points may be along `axis` that lie in a slab across `other`, a later axis. Seen
        /// along the third axis they are within the radius of the line, and so within radius / cos
        /// along `axis`.
        Interval beside(int axis, int other, const Interval& slab) const {
            if (std::abs(direction[other]) < kParallel) return {-kFarthest, kFarthest};
            const double a = at(axis, (slab.from - origin[other]) * inverse[other]);
            const double b = at(axis, (slab.to - origin[other]) * inverse[other]);
            const double far = aside[axis + other - 1];
            return {std::min(a, b) - far, std::max(a, b) + far};
        }

        std::array<double, 3> origin, direction, inverse{}, aside{};
        double length, radius;
    };

    static constexpr double kParallel = 1e-7;  // below it a direction has nothing along an axis
    static constexpr double kFarthest = 1e30;

    /// Between these coordinates lie the points of a layer or row of cells.
    Interval slab(int axis, int cell) const {
        return {lower_[axis] + cell * width_, lower_[axis] + (cell + 1) * width_};
    }
    std::pair<int, int> cells(int axis, const Interval& range) const {
        if (range.empty()) return {0, -1};
        const double last = count_[axis] - 1;
        const double from = std::floor((range.from - lower_[axis]) * inverse_width_);
        const double to = std::floor((range.to - lower_[axis]) * inverse_width_);
        if (!(from <= last && to >= 0)) return {0, -1};
        return {int(std::max(from, 0.0)), int(std::min(to, last))};
    }
    std::uint32_t bucket(int x, int y, int z) const {
        return std::uint32_t((z * count_[1] + y) * count_[0] + x);
    }
    void lay_cells(std::span<const Vec3> points, std::uint32_t thinning);

    std::array<double, 3> lower_{};
    std::array<int, 3> count_{};  // of cells along each axis
    double width_ = 1, inverse_width_ = 1;
    double radius_ = 0;  // with a margin for rounding
    BucketSort sort_;
};

}  // namespace aips
