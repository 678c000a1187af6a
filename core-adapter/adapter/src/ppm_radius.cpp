// Radii of mode=ppm.
#include "ppm_radius.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "aips/core/ppm_statistics.h"

namespace aips {

SearchRadii PpmRadius::before_pass(std::uint64_t /*pass*/, const PassPhotons& /*photons*/,
                                   const EyeImage& image) {
    if (radii_.empty()) {
        const auto radius = float(initial_radius(settings_, image, floor_.least()));
        radii_.assign(image.visible_points.size(), radius);
        photons_.assign(image.visible_points.size(), 0);
    }
    for (std::size_t i = 0; i < radii_.size(); ++i)
        radii_[i] = std::max(radii_[i], floor_.at(image.visible_points[i].position));
    return SearchRadii(std::span<const float>(radii_));
}

void PpmRadius::after_pass(const PhotonFlux& flux) {
    tbb::parallel_for(std::size_t{0}, radii_.size(), [&](std::size_t i) {
        const PpmStep step = ppm_step(photons_[i], flux.accepted[i], settings_.alpha);
        photons_[i] = step.photons;
        radii_[i] *= float(std::sqrt(step.share));
    });
}

}  // namespace aips
