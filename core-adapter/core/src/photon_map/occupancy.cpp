// Marking the reach of visible points.
#include "aips/core/photon_map/occupancy.h"

#include <atomic>
#include <bit>

namespace aips {
namespace {

/// Bits of the occupancy for each visible point.
constexpr std::size_t kBitsPerPoint = 16;

constexpr std::size_t kBlockBits = 512;
constexpr std::size_t kMinBits = 2 * kBlockBits;
constexpr std::size_t kMaxBits = std::size_t(1) << 31;
constexpr std::size_t kPointsPerChunk = std::size_t(1) << 11;

std::size_t table_bits(std::size_t points) {
    return std::clamp(std::bit_ceil(std::min(points, kMaxBits) * kBitsPerPoint), kMinBits,
                      kMaxBits);
}

/// Squared distance from `p` to the interval of cell `c`, in units of cells; 0 inside.
double axis_gap(double scaled, std::int64_t c) {
    const double gap = std::max({double(c) - scaled, scaled - double(c + 1), 0.0});
    return gap * gap;
}

/// Sets bits that other threads may be setting too. Neighbouring points share their cells: most
/// bits are set already, and a look is cheaper than a locked write.
void set_bits(std::uint64_t& word, std::uint64_t bits) {
    const std::atomic_ref<std::uint64_t> shared(word);
    if ((shared.load(std::memory_order_relaxed) & bits) == bits) return;
    shared.fetch_or(bits, std::memory_order_relaxed);
}

}  // namespace

void OccupancyGrid::build(std::span<const Vec3> points, float radius, const ParallelFor& parallel) {
    cells_ = CellGrid(radius);
    const std::size_t bits = table_bits(points.size());
    block_mask_ = bits / kBlockBits - 1;
    bits_.reserve(bits / 64);
    bits_.assign(bits / 64, 0);
    in_chunks(points.size(), kPointsPerChunk, parallel, [&](std::size_t first, std::size_t last) {
        for (const Vec3& point : points.subspan(first, last - first)) {
            if (is_finite(point)) mark_ball(point);
        }
    });
}

void OccupancyGrid::mark_ball(Vec3 point) {
    const CellRange range = cells_.cells_of_ball(point, cells_.radius());
    const double reach = cells_.scaled_radius(cells_.radius());
    const double reach_squared = reach * reach;
    for (std::int64_t z = range.lower.z; z <= range.upper.z; ++z) {
        const double gap_z = axis_gap(cells_.scaled(point.z), z);
        for (std::int64_t y = range.lower.y; y <= range.upper.y; ++y) {
            const double gap_yz = gap_z + axis_gap(cells_.scaled(point.y), y);
            for (std::int64_t x = range.lower.x; x <= range.upper.x; ++x) {
                if (gap_yz + axis_gap(cells_.scaled(point.x), x) > reach_squared) continue;
                const Cell cell{x, y, z};
                set_bits(bits_[word(cell)], std::uint64_t(1) << bit(cell));
            }
        }
    }
}

std::size_t OccupancyGrid::memory_bound_bytes(std::size_t max_points) {
    return table_bits(max_points) / 8;
}

}  // namespace aips
