// Density estimation by light.
#include "estimate/photon_energy.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "estimate/gather.h"

namespace aips {

void add_photon_energy(const EyeImage& image, const PhotonGrid& grid,
                       std::span<const Photon> photons, const GatherRadii& radii,
                       const PhotonOcclusion* occlusion, LuminanceByLight& sums) {
    constexpr std::size_t kChunks = 256;  // a fixed number: their sums are joined in order
    std::array<LuminanceByLight, kChunks> chunks;
    const std::size_t points = image.visible_points.size();
    tbb::parallel_for(std::size_t{0}, kChunks, [&](std::size_t c) {
        for (std::size_t i = points * c / kChunks; i < points * (c + 1) / kChunks; ++i) {
            const VisiblePoint& point = image.visible_points[i];
            if (!point.tells_lights) continue;
            const float radius = radii.of(i);
            const Rgb f = left_out_f(point);
            const Rgb scale =
                point.throughput * f * float(1 / (double(kPi) * double(radius) * double(radius)));
            grid.for_each_in_radius(point.position, radius, [&](const GridPhoton& photon) {
                const auto value = double(luminance(scale * contribution(point, photon, radius)));
                // What is no light is refused, and counted, by the gather itself.
                if (!(value > 0) || !std::isfinite(value)) return;
                if (occlusion && occlusion->blocks_if_asked(point, image.positions[point.sample],
                                                            photon, radius))
                    return;
                chunks[c].add(photons[photon.index].light, value);
            });
        }
    });
    for (const LuminanceByLight& chunk : chunks)
        sums.add(chunk);
}

}  // namespace aips
