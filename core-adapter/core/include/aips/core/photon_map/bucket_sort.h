// Points sorted into numbered buckets: what grids over points stand on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "aips/core/base/parallel.h"
#include "aips/core/base/unwritten.h"
#include "aips/core/base/vector.h"

namespace aips {

/// Room for `count` entries in steps of 4096: growth is rare, and bounded by the largest count.
constexpr std::size_t rounded_capacity(std::size_t count) {
    return (count / 4096 + 1) * 4096;
}

/// A point's slot is its place in the sorted order; slots of a bucket are neighbours, and so are
/// buckets. Buffers are reused: sorting no more points than before allocates nothing. Queries are
/// const and may run on many threads.
class BucketSort {
  public:
    /// Buckets for so many points that each has about one: a power of two, below 2^31.
    static std::size_t usual_buckets(std::size_t points);

    /// Writes the buckets of points [first, last) to `buckets`, one each.
    using BucketsOf =
        std::function<void(std::size_t first, std::size_t last, std::span<std::uint32_t> buckets)>;

    /// Sorts `points` (fewer than 2^32) into `buckets`, a power of two that usual_buckets() is no
    /// less than. Points that are not finite are left out, whatever `buckets_of` says of them. The
    /// result is the same for every `parallel`: slots of a bucket are in the points' order.
    void sort(std::span<const Vec3> points, std::size_t buckets, const BucketsOf& buckets_of,
              const ParallelFor& parallel);

    /// First slot of a bucket; the one after its last is that of the next bucket.
    std::uint32_t first_slot(std::uint32_t bucket) const { return start_[bucket]; }
    std::size_t buckets() const { return std::size_t(mask_) + 1; }
    /// Points that were not left out.
    std::size_t size() const { return positions_.size(); }
    /// [slot]: number of the point among those that were sorted.
    std::span<const std::uint32_t> order() const { return order_; }
    /// [slot]
    std::span<const Vec3> positions() const { return positions_; }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() when no sort ever has more than `max_points`.
    static std::size_t memory_bound_bytes(std::size_t max_points);

  private:
    /// A point on its way to its bucket.
    struct Key {
        std::uint32_t bucket, index;
    };

    void reserve(std::size_t points);
    std::uint32_t partition_count() const;
    void count_partitions(std::span<const Vec3> points, const BucketsOf& buckets_of,
                          const ParallelFor& parallel);
    void scan_partitions();
    void scatter_keys(const ParallelFor& parallel);
    void sort_partition(std::span<const Vec3> points, std::uint32_t partition);

    std::uint32_t mask_ = 0;                      // buckets less one
    unsigned partition_shift_ = 0;                // bucket >> shift is its partition
    UnwrittenVector<std::uint32_t> start_;        // [bucket]: first slot; one more at the end
    UnwrittenVector<std::uint32_t> bucket_;       // [point]: its bucket, kNoBucket if left out
    std::vector<std::uint32_t> cursor_;           // [chunk][partition]: where its next key goes
    std::vector<std::uint32_t> partition_start_;  // [partition]: first key; one more at the end
    UnwrittenVector<Key> keys_;                   // by partition, then in the points' order
    UnwrittenVector<Vec3> positions_;             // by bucket, then in the points' order
    UnwrittenVector<std::uint32_t> order_;        // as positions_
};

}  // namespace aips
