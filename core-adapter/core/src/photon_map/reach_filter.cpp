// Marking the cells that a few points reach.
#include "aips/core/photon_map/reach_filter.h"

#include <algorithm>
#include <atomic>
#include <bit>

namespace aips {
namespace {

/// Bits of the filter for each photon, where there are few.
constexpr std::size_t kFilterBitsPerPoint = 64;

constexpr std::size_t kFilterChunkPoints = std::size_t(1) << 9;

std::size_t filter_words(std::size_t points) {
    return std::bit_ceil(std::max<std::size_t>(points, 1) * kFilterBitsPerPoint) / 64;
}

}  // namespace

void ReachFilter::build(std::span<const Vec3> points, float radius, const ParallelFor& parallel) {
    cells_ = CellGrid(radius);
    bits_.assign(filter_words(points.size()), 0);
    mask_ = bits_.size() * 64 - 1;
    in_chunks(points.size(), kFilterChunkPoints, parallel,
              [&](std::size_t first, std::size_t last) {
                  for (const Vec3& point : points.subspan(first, last - first)) {
                      if (is_finite(point)) mark(point);
                  }
              });
}

// Bits are set in any order, and some by several threads.
void ReachFilter::mark(Vec3 point) {
    const CellRange range = cells_.cells_of_ball(point, cells_.radius());
    for (std::int64_t z = range.lower.z; z <= range.upper.z; ++z) {
        for (std::int64_t y = range.lower.y; y <= range.upper.y; ++y) {
            for (std::int64_t x = range.lower.x; x <= range.upper.x; ++x) {
                const std::uint64_t bit = hash_cell({x, y, z}) & mask_;
                const std::uint64_t set = std::uint64_t(1) << bit % 64;
                const std::atomic_ref word(bits_[bit / 64]);
                // Most are set already; to see that takes less than to set one again.
                if ((word.load(std::memory_order_relaxed) & set) == 0)
                    word.fetch_or(set, std::memory_order_relaxed);
            }
        }
    }
}

std::size_t ReachFilter::memory_bound_bytes(std::size_t max_points) {
    // Vectors grow by doubling.
    return 2 * filter_words(max_points) * sizeof(std::uint64_t);
}

}  // namespace aips
