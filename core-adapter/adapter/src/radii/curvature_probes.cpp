// Gather of the probes.
#include "radii/curvature_probes.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

template <class Blocks>
void gather_probe(const VisiblePoint& point, const PhotonGrid& grid, float radius,
                  const Blocks& blocks, ProbeSums& sums) {
    const Rgb weight = point.throughput * left_out_f(point);
    const float inverse = 1 / (radius * radius);
    grid.for_each_in_radius(point.position, radius, [&](const GridPhoton& photon) {
        const Rgb brought = contribution(point, photon, radius);
        const auto value = double(luminance(weight * brought));
        if (!(value > 0) || !std::isfinite(value) || blocks(photon)) return;
        const float share = length_squared(photon.position - point.position) * inverse;
        sums.add(value, double(share));
    });
}

}  // namespace

void gather_probes(const EyeImage& image, const PhotonGrid& grid, const GatherRadii& radii,
                   const PhotonOcclusion* occlusion, std::span<ProbeSums> sums) {
    const PointOwners& owners = image.owners;
    SharedWork work = work_on_points(owners, nullptr);
    const std::size_t points = image.visible_points.size();
    const std::size_t first = owners.first(points), last = owners.last(points);
    tbb::parallel_for(std::size_t{0}, radii.probes.size(), [&](std::size_t i) {
        const std::size_t number = radii.probes[i];
        if (number < first || number >= last) return;
        const VisiblePoint& point = image.visible_points[number];
        const auto blocks = [&](const GridPhoton& photon) {
            return occlusion && occlusion->blocks_if_asked(point, image.positions[point.sample],
                                                           photon, radii.probe_radius);
        };
        gather_probe(point, grid, radii.probe_radius, blocks, sums[i]);
    });
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        for (std::size_t i = 0; i < radii.probes.size(); ++i) {
            const std::size_t point = radii.probes[i];
            if (point >= owners.begins[rank] && point < owners.begins[rank + 1])
                plain(archive, sums.subspan(i, 1));
        }
    });
}

}  // namespace aips
