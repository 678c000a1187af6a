// Which regions hold visible points at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/parallel.h"
#include "aips/core/photon_map/cell_hash.h"

namespace aips {

/// A hashed set of the grid cells within reach of a visible point, so that photons out of reach
/// need not be stored. Conservative: hash collisions and corners of cells may say yes in vain.
/// Queries are const and may run on many threads.
class OccupancyGrid {
  public:
    /// Marks what lies within `radius` of any of the points; reuses the memory. Points that are
    /// not finite are left out. The result is the same for every `parallel`.
    void build(std::span<const Vec3> points, float radius,
               const ParallelFor& parallel = serial_for);

    /// Never false when a visible point lies within the radius of `p`; false if `p` is not finite.
    bool near_visible_point(Vec3 p) const {
        if (bits_.empty() || !is_finite(p)) return false;
        const Cell cell = cells_.cell(p);
        return (bits_[word(cell)] >> bit(cell)) & 1;
    }

    std::size_t memory_bytes() const { return bits_.capacity() * sizeof(std::uint64_t); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points);

  private:
    // Blocks of 8 x 8 x 8 cells are hashed, not cells: neighbours share a block's 64 bytes, and
    // photons that land side by side find them in the cache. A layer of equal z is a word.
    std::uint64_t word(Cell c) const {
        const Cell block{c.x >> 3, c.y >> 3, c.z >> 3};
        return (hash_cell(block) & block_mask_) * 8 + std::uint64_t(c.z & 7);
    }
    static unsigned bit(Cell c) { return unsigned(c.x & 7) | unsigned(c.y & 7) << 3; }

    void mark_ball(Vec3 point);

    CellGrid cells_;
    std::uint64_t block_mask_ = 0;
    std::vector<std::uint64_t> bits_;  // [block][z]
};

}  // namespace aips
