// Which regions hold visible points at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/cell_hash.h"

namespace aips {

/// A hashed set of the grid cells within reach of a visible point, so that landings out of reach
/// need not be stored. Conservative: hash collisions and corners of cells may say yes in vain.
/// Queries are const and may run on many threads.
class OccupancyGrid {
  public:
    /// Marks what lies within `radius` of any of the points; reuses the memory. Points that are
    /// not finite are left out.
    void build(std::span<const Vec3> points, float radius);

    /// Never false when a visible point lies within the radius of `p`; false if `p` is not finite.
    bool near_visible_point(Vec3 p) const {
        if (bits_.empty() || !is_finite(p)) return false;
        const std::uint64_t bit = hash_cell(cells_.cell(p)) & mask_;
        return (bits_[bit >> 6] >> (bit & 63)) & 1;
    }

    std::size_t memory_bytes() const { return bits_.capacity() * sizeof(std::uint64_t); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points);

  private:
    void mark_ball(Vec3 point);

    CellGrid cells_;
    std::uint64_t mask_ = 0;
    std::vector<std::uint64_t> bits_;
};

}  // namespace aips
