// Where few points are within reach: asked before a range query that would find nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/parallel.h"
#include "aips/core/photon_map/cell_hash.h"

namespace aips {

/// A hashed set of the cells that lie within a radius of any of a few points, far apart as a rule.
/// (OccupancyGrid is for many that are neighbours.) Conservative: it may say yes in vain. Queries
/// are const and may run on many threads.
class ReachFilter {
  public:
    /// Of the finite ones of `points`; reuses the memory. The result is the same for every
    /// `parallel`.
    void build(std::span<const Vec3> points, float radius,
               const ParallelFor& parallel = serial_for);
    /// Lets everything pass.
    void clear() { mask_ = 0; }

    /// Never false when a point lies within the radius of `p`, which is finite.
    bool may_reach(Vec3 p) const {
        if (mask_ == 0) return true;
        const std::uint64_t bit = hash_cell(cells_.cell(p)) & mask_;
        return (bits_[bit / 64] >> bit % 64) & 1;
    }

    std::size_t memory_bytes() const { return bits_.capacity() * sizeof(std::uint64_t); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points);

  private:
    void mark(Vec3 point);

    CellGrid cells_;
    std::uint64_t mask_ = 0;           // bits less one; 0: all pass
    std::vector<std::uint64_t> bits_;  // by hash
};

}  // namespace aips
