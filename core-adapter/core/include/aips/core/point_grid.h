// Whether any point of a set lies within a radius: exact, where OccupancyGrid is conservative.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/cell_hash.h"

namespace aips {

/// Points sorted into hash buckets of cells twice as wide as the radius. Buffers are reused.
/// Queries are const and may run on many threads.
class PointGrid {
  public:
    /// Sorts `points` (fewer than 2^31); those that are not finite are left out.
    void build(std::span<const Vec3> points, float radius);

    /// Whether a point lies within the radius of `p`; false if `p` is not finite.
    bool any_within_radius(Vec3 p) const;

    std::size_t memory_bytes() const {
        return start_.capacity() * sizeof(std::uint32_t) + points_.capacity() * sizeof(Vec3);
    }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points);

  private:
    std::size_t bucket(Cell c) const { return std::size_t(hash_cell(c) & mask_); }

    CellGrid cells_;
    std::uint64_t mask_ = 0;
    std::vector<std::uint32_t> start_;  // [bucket]: first point; one more at the end
    std::vector<Vec3> points_;          // by bucket
};

}  // namespace aips
