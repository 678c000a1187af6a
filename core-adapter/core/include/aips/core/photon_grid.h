// Range queries over landings: a hashed uniform grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/cell_hash.h"
#include "aips/core/landing.h"

namespace aips {

/// Landings sorted into hash buckets of cells twice as wide as the search radius. Buffers are
/// reused: building for no more landings than before allocates nothing. Queries are const and may
/// run on many threads.
class LandingGrid {
  public:
    /// Sorts `landings` (fewer than 2^32) for searches up to `radius`. The span is kept, and must
    /// outlive the queries. Landings at positions that are not finite are left out.
    void build(std::span<const Landing> landings, float radius);

    /// Calls `visit(const Landing&)` once for each landing with |position - p| <= radius, in an
    /// order that is a function of the landings alone. `radius` beyond radius() is cut to it. The
    /// landing's number is its address less landings().data().
    template <class F>
    void for_each_in_radius(Vec3 p, float radius, F&& visit) const {
        if (entries_.empty() || !is_finite(p) || !(radius >= 0)) return;
        radius = std::min(radius, cells_.radius());
        const float radius_squared = radius * radius;
        Buckets buckets;
        const unsigned count = buckets_of_ball(p, radius, buckets);
        for (unsigned i = 0; i < count; ++i) {
            const std::uint32_t end = start_[buckets[i] + 1];
            for (std::uint32_t e = start_[buckets[i]]; e < end; ++e) {
                if (length_squared(entries_[e].position - p) <= radius_squared) {
                    visit(landings_[entries_[e].index]);
                }
            }
        }
    }

    std::span<const Landing> landings() const { return landings_; }
    /// Landings that queries can find.
    std::size_t size() const { return entries_.size(); }
    /// Greatest radius of a query.
    float radius() const { return cells_.radius(); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() when no build ever has more than `max_landings`.
    static std::size_t memory_bound_bytes(std::size_t max_landings);

  private:
    static constexpr unsigned kMaxBuckets = 27;
    using Buckets = std::array<std::uint32_t, kMaxBuckets>;

    struct Entry {
        Vec3 position;  // copied, so that a bucket's positions are contiguous
        std::uint32_t index = 0;
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
    void count_buckets();
    void scatter_entries();

    std::span<const Landing> landings_;
    CellGrid cells_;
    std::uint32_t mask_ = 0;
    std::vector<std::uint32_t> start_;      // [bucket]: first entry; one more at the end
    std::vector<std::uint32_t> bucket_of_;  // [landing]: its bucket, kNoBucket if not stored
    std::vector<Entry> entries_;
};

}  // namespace aips
