// Boxes cut into cells, and the way of a ray through them.
//
// Reference: Amanatides & Woo 1987, "A fast voxel traversal algorithm for ray tracing".
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lxs/sdk/types.h"

namespace lxs {

/// Cells of one size that fill a box.
struct RegularGrid {
    using Cell = std::array<int, 3>;  ///< numbers along the axes

    Bounds bounds;
    Cell cells{1, 1, 1};  ///< along each axis
    Vec3 width{1.0f};     ///< of a cell; of a flat box a little more than none

    RegularGrid() = default;
    /// Cells that are nearly cubes, `most` of them along the longest side.
    RegularGrid(const Bounds& box, int most) : bounds(box) {
        const Vec3 size = box.size();
        const float longest = std::max({size.x, size.y, size.z, 1e-30f});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = int(axis);
            cells[axis] = std::clamp(int(std::ceil(size[i] / longest * float(most))), 1, most);
            width[i] = std::max(size[i], 1e-6f * longest) / float(cells[axis]);
        }
    }

    std::size_t count() const {
        return std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(cells[2]);
    }
    std::size_t index(const Cell& cell) const {
        return (std::size_t(cell[2]) * std::size_t(cells[1]) + std::size_t(cell[1])) *
                   std::size_t(cells[0]) +
               std::size_t(cell[0]);
    }
    /// The cell of a place; of one outside of the box, the nearest to it.
    Cell cell_at(const Vec3& position) const {
        Cell cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = int(axis);
            cell[axis] =
                std::clamp(int((position[i] - bounds.min[i]) / width[i]), 0, cells[axis] - 1);
        }
        return cell;
    }
};

/// The cells that a ray meets on its first `length`, which may be infinite, one after the other.
/// The grid outlives it.
class GridWalk {
  public:
    GridWalk(const RegularGrid& grid, const Vec3& origin, const Vec3& direction, double length)
        : grid_(grid) {
        double enter = 0, leave = length;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = direction[axis], o = origin[axis];
            const double low = grid.bounds.min[axis], high = grid.bounds.max[axis];
            if (d == 0) {
                if (o < low || o > high) leave = -1;
                continue;
            }
            const double a = (low - o) / d, b = (high - o) / d;
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        from_ = enter;
        end_ = leave;
        if (!inside()) return;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = int(axis);
            const double d = direction[i], width = grid.width[i], low = grid.bounds.min[i];
            const double at = (origin[i] + d * enter - low) / width;
            cell_[axis] = std::clamp(int(at), 0, grid.cells[axis] - 1);
            step_[axis] = d < 0 ? -1 : 1;
            if (d == 0) continue;
            next_[axis] = (low + (cell_[axis] + (d > 0)) * width - origin[i]) / d;
            stride_[axis] = width / std::abs(d);
        }
    }

    /// Whether there is a cell, or one more.
    bool inside() const { return from_ < end_; }
    /// Distances along the ray between which it is in the cell.
    double from() const { return from_; }
    double to() const { return std::min(end_, next_[nearest()]); }
    std::size_t cell() const { return grid_.index(cell_); }
    void go_on() {
        const std::size_t axis = nearest();
        from_ = std::max(from_, next_[axis]);
        next_[axis] += stride_[axis];
        cell_[axis] += step_[axis];
        if (cell_[axis] < 0 || cell_[axis] >= grid_.cells[axis]) end_ = from_;
    }

  private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    std::size_t nearest() const {
        return std::size_t(std::min_element(next_.begin(), next_.end()) - next_.begin());
    }

    const RegularGrid& grid_;
    double from_ = 0, end_ = 0;
    RegularGrid::Cell cell_{}, step_{};
    std::array<double, 3> next_{kNever, kNever, kNever}, stride_{kNever, kNever, kNever};
};

}  // namespace lxs
