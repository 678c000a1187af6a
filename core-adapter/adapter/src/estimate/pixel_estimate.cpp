// The radiance estimate of a pass.
#include "estimate/pixel_estimate.h"

#include <tbb/parallel_for.h>

#include "aips/core/sampling/sampling.h"

namespace aips {

void estimate_pixels(const EyeImage& image, const PhotonFlux& flux, const SearchRadii& radii,
                     std::uint64_t photon_paths, Refusals& refusals,
                     std::vector<Rgb>& photon_radiance) {
    photon_radiance.assign(image.radiance.size(), Rgb{});
    const std::uint32_t groups = image.groups;
    tbb::parallel_for(std::size_t{0}, image.visible_points.size(), [&](std::size_t i) {
        const VisiblePoint& point = image.visible_points[i];
        // In double: r^2 times the number of paths leaves the range of float in tiny scenes.
        const double radius = double(radii.of(i));
        const double scale = 1 / (double(kPi) * radius * radius * double(photon_paths));
        const Rgb f = point.bsdf ? kWhite : point.kd * kInvPi;
        for (std::uint32_t g = 0; g < groups; ++g) {
            const Rgb sum = flux.flux[i * groups + g];
            const Rgb density{float(sum.r * scale), float(sum.g * scale), float(sum.b * scale)};
            const Rgb value = point.throughput * f * density;
            // Each eye path has one visible point at the most: no two iterations share an entry.
            Rgb& brought = photon_radiance[std::size_t(point.sample) * groups + g];
            refusals.add(brought, value, point.material);
        }
    });
}

}  // namespace aips
