// Range queries over landings: a hashed uniform grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/cell_hash.h"
#include "aips/core/landing.h"
#include "aips/core/parallel.h"

namespace aips {

/// What density estimation needs of a landing: compact, and in the order in which queries read.
struct GridPhoton {
    Vec3 position;
    Vec3 direction;  ///< unit, back to where the photon came from
    Rgb power;       ///< watts, not divided by the number of photon paths
    Vec3 normal;     ///< unit geometric normal of the surface, of either side
    std::uint32_t light_group = 0;
    std::uint32_t index = 0;  ///< number of the landing among those that were sorted
};

/// Landings sorted into hash buckets of cells twice as wide as the search radius. Buffers are
/// reused: building for no more landings than before allocates nothing. Queries are const and may
/// run on many threads.
class LandingGrid {
  public:
    /// Sorts copies of `landings` (fewer than 2^32) for searches up to `radius`. Landings at
    /// positions that are not finite are left out. The result is the same for every `parallel`.
    void build(std::span<const Landing> landings, float radius,
               const ParallelFor& parallel = serial_for);

    /// Calls `visit(const GridPhoton&)` once for each landing with |position - p| <= radius, in an
    /// order that is a function of the landings alone. `radius` beyond radius() is cut to it.
    template <class F>
    void for_each_in_radius(Vec3 p, float radius, F&& visit) const {
        if (positions_.empty() || !is_finite(p) || !(radius >= 0)) return;
        radius = std::min(radius, cells_.radius());
        const float radius_squared = radius * radius;
        Buckets buckets;
        const unsigned count = buckets_of_ball(p, radius, buckets);
        for (unsigned i = 0; i < count; ++i) {
            const std::uint32_t end = start_[buckets[i] + 1];
            for (std::uint32_t e = start_[buckets[i]]; e < end; ++e) {
                if (length_squared(positions_[e] - p) <= radius_squared) visit(photons_[e]);
            }
        }
    }

    /// Landings that queries can find.
    std::size_t size() const { return positions_.size(); }
    /// Greatest radius of a query.
    float radius() const { return cells_.radius(); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() when no build ever has more than `max_landings`.
    static std::size_t memory_bound_bytes(std::size_t max_landings);

  private:
    static constexpr unsigned kMaxBuckets = 27;
    using Buckets = std::array<std::uint32_t, kMaxBuckets>;

    /// A landing on its way to its bucket.
    struct Keyed {
        std::uint32_t bucket, index;
    };

    std::uint32_t bucket(Cell c) const { return std::uint32_t(hash_cell(c)) & mask_; }

    /// Distinct buckets of the cells that the ball touches. Two cells may share one, and visiting
    /// it twice would count its photons twice.
    unsigned buckets_of_ball(Vec3 p, float radius, Buckets& buckets) const {
        const CellRange range = cells_.cells_of_ball(p, radius);
        unsigned count = 0;
        for (std::int64_t z = range.lower.z; z <= range.upper.z; ++z) {
            for (std::int64_t y = range.lower.y; y <= range.upper.y; ++y) {
                for (std::int64_t x = range.lower.x; x <= range.upper.x; ++x) {
                    const std::uint32_t b = bucket({x, y, z});
                    unsigned i = 0;
                    while (i < count && buckets[i] != b)
                        ++i;
                    if (i == count) buckets[count++] = b;
                }
            }
        }
        return count;
    }

    void reserve(std::size_t landings);
    std::uint32_t partition_count() const;
    void count_partitions(std::span<const Landing> landings, const ParallelFor& parallel);
    void scan_partitions();
    void scatter_keys(const ParallelFor& parallel);
    void sort_partition(std::span<const Landing> landings, std::uint32_t partition);

    CellGrid cells_;
    std::uint32_t mask_ = 0;                      // buckets less one
    unsigned partition_shift_ = 0;                // bucket >> shift is its partition
    std::vector<std::uint32_t> start_;            // [bucket]: first photon; one more at the end
    std::vector<std::uint32_t> bucket_;           // [landing]: its bucket, kNoBucket if not stored
    std::vector<std::uint32_t> cursor_;           // [chunk][partition]: where its next key goes
    std::vector<std::uint32_t> partition_start_;  // [partition]: first key; one more at the end
    std::vector<Keyed> keys_;                     // by partition, then in the landings' order
    std::vector<Vec3> positions_;                 // by bucket, then in the landings' order
    std::vector<GridPhoton> photons_;             // as positions_
};

}  // namespace aips
