// Cells of a hashed grid as buckets.
#include "aips/core/photon_map/cell_sort.h"

namespace aips {

void CellSort::build(std::span<const Vec3> points, float radius, const ParallelFor& parallel) {
    cells_ = CellGrid(radius);
    const std::size_t buckets = BucketSort::usual_buckets(points.size());
    const auto mask = std::uint32_t(buckets - 1);
    const auto buckets_of = [&](std::size_t first, std::size_t last,
                                std::span<std::uint32_t> numbers) {
        for (std::size_t i = first; i < last; ++i)
            numbers[i - first] = is_finite(points[i]) ? bucket(cells_.cell(points[i]), mask) : 0;
    };
    sort_.sort(points, buckets, buckets_of, parallel);
}

}  // namespace aips
