// Counting sort of landings into hash buckets.
#include "aips/core/photon_grid.h"

#include <bit>

namespace aips {
namespace {

constexpr std::uint32_t kNoBucket = 0xFFFFFFFFu;
/// Keeps bucket numbers in 31 bits.
constexpr std::size_t kMaxBucketCount = std::size_t(1) << 30;

/// About one landing a bucket.
std::size_t bucket_count(std::size_t landings) {
    return std::bit_ceil(std::clamp<std::size_t>(landings, 1, kMaxBucketCount));
}

}  // namespace

void LandingGrid::build(std::span<const Landing> landings, float radius) {
    landings_ = landings;
    cells_ = CellGrid(radius);
    mask_ = static_cast<std::uint32_t>(bucket_count(landings.size()) - 1);
    reserve(landings.size());
    count_buckets();
    scatter_entries();
}

// Sizes in powers of two: growth is rare, and bounded by the largest build.
void LandingGrid::reserve(std::size_t landings) {
    const std::size_t capacity = std::bit_ceil(std::max<std::size_t>(landings, 1));
    bucket_of_.reserve(capacity);
    entries_.reserve(capacity);
    start_.reserve(bucket_count(capacity) + 1);
}

// Afterwards start_[b + 1] counts the landings of bucket b.
void LandingGrid::count_buckets() {
    start_.assign(std::size_t(mask_) + 2, 0);
    bucket_of_.resize(landings_.size());
    for (std::size_t i = 0; i < landings_.size(); ++i) {
        const Vec3 p = landings_[i].position;
        bucket_of_[i] = is_finite(p) ? bucket(cells_.cell(p)) : kNoBucket;
        if (bucket_of_[i] != kNoBucket) ++start_[bucket_of_[i] + 1];
    }
}

// Stable: within a bucket, entries keep the order of the landings.
void LandingGrid::scatter_entries() {
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start_) {  // start_[b + 1] becomes the first entry of bucket b
        const std::uint32_t count = s;
        s = sum;
        sum += count;
    }
    entries_.resize(sum);
    for (std::size_t i = 0; i < landings_.size(); ++i) {
        if (bucket_of_[i] == kNoBucket) continue;
        entries_[start_[bucket_of_[i] + 1]++] = {landings_[i].position,
                                                 static_cast<std::uint32_t>(i)};
    }
    // Each start_[b + 1] has moved to the end of bucket b, which is the start of bucket b + 1.
}

std::size_t LandingGrid::memory_bytes() const {
    return start_.capacity() * sizeof(std::uint32_t) +
           bucket_of_.capacity() * sizeof(std::uint32_t) + entries_.capacity() * sizeof(Entry);
}

std::size_t LandingGrid::memory_bound_bytes(std::size_t max_landings) {
    const std::size_t capacity = std::bit_ceil(std::max<std::size_t>(max_landings, 1));
    return (bucket_count(capacity) + 1 + capacity) * sizeof(std::uint32_t) +
           capacity * sizeof(Entry);
}

}  // namespace aips
