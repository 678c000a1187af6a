// Counting sort of points into hash buckets.
#include "aips/core/point_grid.h"

#include <bit>

namespace aips {
namespace {

/// About one point a bucket.
std::size_t bucket_count(std::size_t points) {
    return std::bit_ceil(std::max<std::size_t>(points, 1));
}

}  // namespace

void PointGrid::build(std::span<const Vec3> points, float radius) {
    cells_ = CellGrid(radius);
    const std::size_t buckets = bucket_count(points.size());
    mask_ = buckets - 1;
    start_.reserve(buckets + 1);
    points_.reserve(buckets);

    // First start_[b] counts bucket b; summed up, it is the bucket's end; points then fill each
    // bucket from its end, which leaves its start there.
    start_.assign(buckets + 1, 0);
    for (const Vec3& p : points) {
        if (is_finite(p)) ++start_[bucket(cells_.cell(p))];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start_)
        s = sum += s;
    points_.resize(sum);
    for (const Vec3& p : points) {
        if (is_finite(p)) points_[--start_[bucket(cells_.cell(p))]] = p;
    }
}

bool PointGrid::any_within_radius(Vec3 p) const {
    if (points_.empty() || !is_finite(p)) return false;
    const float radius_squared = cells_.radius() * cells_.radius();
    const CellRange range = cells_.cells_of_ball(p, cells_.radius());
    for (std::int64_t z = range.lower.z; z <= range.upper.z; ++z) {
        for (std::int64_t y = range.lower.y; y <= range.upper.y; ++y) {
            for (std::int64_t x = range.lower.x; x <= range.upper.x; ++x) {
                const std::size_t b = bucket({x, y, z});
                for (std::uint32_t i = start_[b]; i < start_[b + 1]; ++i) {
                    if (length_squared(points_[i] - p) <= radius_squared) return true;
                }
            }
        }
    }
    return false;
}

std::size_t PointGrid::memory_bound_bytes(std::size_t max_points) {
    const std::size_t buckets = bucket_count(max_points);
    return (buckets + 1) * sizeof(std::uint32_t) + buckets * sizeof(Vec3);
}

}  // namespace aips
