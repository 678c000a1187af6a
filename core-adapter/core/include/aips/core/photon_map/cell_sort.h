// Points sorted into the cells of a hashed uniform grid: what range queries stand on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "aips/core/base/parallel.h"
#include "aips/core/photon_map/bucket_sort.h"
#include "aips/core/photon_map/cell_hash.h"

namespace aips {

/// Points in hash buckets of cells twice as wide as the gather radius. A point's slot is its place
/// in the sorted order; slots of a bucket are neighbours. Buffers are reused: building for no more
/// points than before allocates nothing. Queries are const and may run on many threads.
class CellSort {
  public:
    /// Sorts `points` (fewer than 2^32) for searches up to `radius`. Points that are not finite are
    /// left out. The result is the same for every `parallel`.
    void build(std::span<const Vec3> points, float radius,
               const ParallelFor& parallel = serial_for);

    /// Calls `visit(slot)` once for each point with |point - p| <= radius until it returns true, in
    /// an order that is a function of the points alone; returns whether it did. `radius` beyond
    /// radius() is cut to it.
    template <class F>
    bool until_in_radius(Vec3 p, float radius, F&& visit) const {
        if (sort_.size() == 0 || !is_finite(p) || !(radius >= 0)) return false;
        radius = std::min(radius, cells_.radius());
        const float radius_squared = radius * radius;
        Buckets buckets;
        const unsigned count = buckets_of_ball(p, radius, buckets);
        for (unsigned i = 0; i < count; ++i) {
            const std::uint32_t end = sort_.first_slot(buckets[i] + 1);
            for (std::uint32_t slot = sort_.first_slot(buckets[i]); slot < end; ++slot) {
                if (length_squared(positions()[slot] - p) <= radius_squared && visit(slot)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Calls `visit(slot)` once for each point with |point - p| <= radius, in the order of
    /// until_in_radius(). For radii that hold many points: which of the candidates lie inside is as
    /// good as random, so they are picked out without a branch before any is visited.
    template <class F>
    void for_each_in_radius(Vec3 p, float radius, F&& visit) const {
        if (sort_.size() == 0 || !is_finite(p) || !(radius >= 0)) return;
        radius = std::min(radius, cells_.radius());
        const float radius_squared = radius * radius;
        Buckets buckets;
        const unsigned count = buckets_of_ball(p, radius, buckets);
        std::array<std::uint32_t, kCandidates> inside;
        unsigned found = 0;
        for (unsigned i = 0; i < count; ++i) {
            const std::uint32_t end = sort_.first_slot(buckets[i] + 1);
            for (std::uint32_t slot = sort_.first_slot(buckets[i]); slot < end; ++slot) {
                inside[found] = slot;
                found += length_squared(positions()[slot] - p) <= radius_squared ? 1 : 0;
                if (found < kCandidates) continue;
                for (const std::uint32_t hit : inside)
                    visit(hit);
                found = 0;
            }
        }
        for (unsigned i = 0; i < found; ++i)
            visit(inside[i]);
    }

    /// Points that queries can find.
    std::size_t size() const { return sort_.size(); }
    /// [slot]: number of the point among those that were sorted.
    std::span<const std::uint32_t> order() const { return sort_.order(); }
    /// [slot]
    std::span<const Vec3> positions() const { return sort_.positions(); }
    /// Greatest radius of a query.
    float radius() const { return cells_.radius(); }
    std::size_t memory_bytes() const { return sort_.memory_bytes(); }
    /// Upper bound of memory_bytes() when no build ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points) {
        return BucketSort::memory_bound_bytes(max_points);
    }

  private:
    static constexpr unsigned kMaxBuckets = 27;
    static constexpr unsigned kCandidates = 64;
    using Buckets = std::array<std::uint32_t, kMaxBuckets>;

    // Blocks of 4 x 4 x 4 cells are hashed, not cells: what lies side by side in the scene does so
    // in memory. Within its block a cell's place is turned by further bits of the hash, so that
    // flat surfaces in blocks that share a place don't all use the same part of it.
    static std::uint32_t bucket(Cell c, std::uint32_t mask) {
        const std::uint64_t hash = hash_cell({c.x >> 2, c.y >> 2, c.z >> 2});
        const auto within = std::uint64_t((c.x & 3) | (c.y & 3) << 2 | (c.z & 3) << 4);
        return std::uint32_t(hash << 6 | (within ^ hash >> 58)) & mask;
    }

    /// Distinct buckets of the cells that the ball touches. Two cells may share one, and visiting
    /// it twice would count its points twice.
    unsigned buckets_of_ball(Vec3 p, float radius, Buckets& buckets) const {
        const CellRange range = cells_.cells_of_ball(p, radius);
        const auto mask = std::uint32_t(sort_.buckets() - 1);
        unsigned count = 0;
        for (std::int64_t z = range.lower.z; z <= range.upper.z; ++z) {
            for (std::int64_t y = range.lower.y; y <= range.upper.y; ++y) {
                for (std::int64_t x = range.lower.x; x <= range.upper.x; ++x) {
                    const std::uint32_t b = bucket({x, y, z}, mask);
                    unsigned i = 0;
                    while (i < count && buckets[i] != b)
                        ++i;
                    if (i == count) buckets[count++] = b;
                }
            }
        }
        return count;
    }

    CellGrid cells_;
    BucketSort sort_;
};

}  // namespace aips
