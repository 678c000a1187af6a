// Whether any point of a set lies within a radius: exact, where OccupancyGrid is conservative.
#pragma once

#include <cstddef>
#include <span>

#include "aips/core/photon_map/cell_sort.h"

namespace aips {

/// Points as a CellSort has them. Queries are const and may run on many threads.
class PointGrid {
  public:
    /// Sorts `points` (fewer than 2^32); those that are not finite are left out.
    void build(std::span<const Vec3> points, float radius,
               const ParallelFor& parallel = serial_for) {
        cells_.build(points, radius, parallel);
    }

    /// Whether a point lies within the radius of `p`; false if `p` is not finite.
    bool any_within_radius(Vec3 p) const {
        return cells_.until_in_radius(p, cells_.radius(), [](std::uint32_t) { return true; });
    }

    std::size_t memory_bytes() const { return cells_.memory_bytes(); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points) {
        return CellSort::memory_bound_bytes(max_points);
    }

  private:
    CellSort cells_;
};

}  // namespace aips
