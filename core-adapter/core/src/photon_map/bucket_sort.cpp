// Counting sort of points into buckets, in two steps: into partitions of buckets, chunk by
// chunk, then each partition by itself. Chunks and partitions are fixed by the input, never by the
// number of threads, and both steps are stable.
#include "aips/core/photon_map/bucket_sort.h"

#include <algorithm>
#include <bit>

namespace aips {
namespace {

/// Most parts that points are dealt out to before each part is sorted (partitions).
constexpr std::uint32_t kMaxPartitions = 256;

constexpr std::uint32_t kNoBucket = 0xFFFFFFFFu;
/// Keeps bucket numbers in 31 bits.
constexpr std::size_t kMaxBucketCount = std::size_t(1) << 30;
constexpr std::size_t kChunkPoints = std::size_t(1) << 14;

std::uint32_t chunk_count(std::size_t points) {
    return static_cast<std::uint32_t>((points + kChunkPoints - 1) / kChunkPoints);
}

}  // namespace

std::size_t BucketSort::usual_buckets(std::size_t points) {
    return std::bit_ceil(std::clamp<std::size_t>(points, 1, kMaxBucketCount));
}

void BucketSort::sort(std::span<const Vec3> points, std::size_t buckets,
                      const BucketsOf& buckets_of, const ParallelFor& parallel) {
    mask_ = static_cast<std::uint32_t>(buckets - 1);
    const auto bits = static_cast<unsigned>(std::bit_width(mask_));
    const unsigned partition_bits = std::bit_width(kMaxPartitions - 1);
    partition_shift_ = bits > partition_bits ? bits - partition_bits : 0;
    reserve(points.size());
    count_partitions(points, buckets_of, parallel);
    scan_partitions();
    scatter_keys(parallel);
    parallel(partition_count(), [&](std::uint32_t p) { sort_partition(points, p); });
}

void BucketSort::reserve(std::size_t points) {
    const std::size_t capacity = rounded_capacity(points);
    // Nothing is kept of the points before, which growing would move.
    for (UnwrittenVector<std::uint32_t>* numbers : {&bucket_, &order_, &start_})
        numbers->clear();
    keys_.clear();
    positions_.clear();
    bucket_.reserve(capacity);
    keys_.reserve(capacity);
    positions_.reserve(capacity);
    order_.reserve(capacity);
    start_.reserve(usual_buckets(capacity) + 1);
    cursor_.reserve(std::size_t(chunk_count(capacity)) * kMaxPartitions);
    partition_start_.reserve(kMaxPartitions + 1);
}

std::uint32_t BucketSort::partition_count() const {
    return (mask_ >> partition_shift_) + 1;
}

void BucketSort::count_partitions(std::span<const Vec3> points, const BucketsOf& buckets_of,
                                  const ParallelFor& parallel) {
    const std::uint32_t partitions = partition_count();
    bucket_.resize(points.size());
    cursor_.assign(std::size_t(chunk_count(points.size())) * partitions, 0);
    in_chunks(points.size(), kChunkPoints, parallel, [&](std::size_t first, std::size_t last) {
        std::uint32_t* count = &cursor_[first / kChunkPoints * partitions];
        buckets_of(first, last, std::span(bucket_).subspan(first, last - first));
        for (std::size_t i = first; i < last; ++i) {
            if (!is_finite(points[i])) bucket_[i] = kNoBucket;
            if (bucket_[i] != kNoBucket) ++count[bucket_[i] >> partition_shift_];
        }
    });
}

// Turns counts into places: partition by partition, and within one chunk by chunk.
void BucketSort::scan_partitions() {
    const std::uint32_t partitions = partition_count();
    partition_start_.assign(partitions + 1, 0);
    std::uint32_t sum = 0;
    for (std::uint32_t p = 0; p < partitions; ++p) {
        partition_start_[p] = sum;
        for (std::size_t i = p; i < cursor_.size(); i += partitions) {
            const std::uint32_t count = cursor_[i];
            cursor_[i] = sum;
            sum += count;
        }
    }
    partition_start_[partitions] = sum;
    keys_.resize(sum);
    positions_.resize(sum);
    order_.resize(sum);
    start_.resize(std::size_t(mask_) + 2);
    start_.back() = sum;
}

void BucketSort::scatter_keys(const ParallelFor& parallel) {
    const std::uint32_t partitions = partition_count();
    in_chunks(bucket_.size(), kChunkPoints, parallel, [&](std::size_t first, std::size_t last) {
        std::uint32_t* next = &cursor_[first / kChunkPoints * partitions];
        for (std::size_t i = first; i < last; ++i) {
            if (bucket_[i] == kNoBucket) continue;
            keys_[next[bucket_[i] >> partition_shift_]++] = {bucket_[i],
                                                             static_cast<std::uint32_t>(i)};
        }
    });
}

void BucketSort::sort_partition(std::span<const Vec3> points, std::uint32_t partition) {
    const std::span keys = std::span(keys_).subspan(
        partition_start_[partition], partition_start_[partition + 1] - partition_start_[partition]);
    const std::size_t first = std::size_t(partition) << partition_shift_;
    const std::span start = std::span(start_).subspan(first, std::size_t(1) << partition_shift_);
    std::ranges::fill(start, 0);
    for (const Key& key : keys)
        ++start[key.bucket - first];
    // From behind: each start moves from the end of its bucket to its beginning.
    std::uint32_t end = partition_start_[partition];
    for (std::uint32_t& s : start)
        s = end += s;
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
        const std::uint32_t place = --start[key->bucket - first];
        positions_[place] = points[key->index];
        order_[place] = key->index;
    }
}

std::size_t BucketSort::memory_bytes() const {
    return (start_.capacity() + bucket_.capacity() + cursor_.capacity() +
            partition_start_.capacity() + order_.capacity()) *
               sizeof(std::uint32_t) +
           keys_.capacity() * sizeof(Key) + positions_.capacity() * sizeof(Vec3);
}

std::size_t BucketSort::memory_bound_bytes(std::size_t max_points) {
    const std::size_t capacity = rounded_capacity(max_points);
    const std::size_t numbers = usual_buckets(capacity) + 1 + 2 * capacity +
                                std::size_t(chunk_count(capacity)) * kMaxPartitions +
                                kMaxPartitions + 1;
    return numbers * sizeof(std::uint32_t) + capacity * (sizeof(Key) + sizeof(Vec3));
}

}  // namespace aips
