// Radii of mode=ppm.
#include "ppm_radius.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aips/core/ppm_statistics.h"

namespace aips {

SearchRadii PpmRadius::before_pass(std::uint64_t /*pass*/, const PassPhotons& /*photons*/,
                                   const EyeImage& image) {
    if (radii_.empty()) {
        const auto radius = float(initial_radius(settings_, image, smallest_));
        radii_.assign(image.visible_points.size(), radius);
        photons_.assign(image.visible_points.size(), 0);
    }
    SearchRadii radii;
    radii.largest = *std::max_element(radii_.begin(), radii_.end());
    radii.mean = float(std::accumulate(radii_.begin(), radii_.end(), 0.0) / double(radii_.size()));
    radii.per_point = radii_;
    return radii;
}

void PpmRadius::after_pass(const PhotonFlux& flux) {
    tbb::parallel_for(std::size_t{0}, radii_.size(), [&](std::size_t i) {
        const PpmStep step = ppm_step(photons_[i], flux.accepted[i], settings_.alpha);
        photons_[i] = step.photons;
        radii_[i] *= float(std::sqrt(step.share));
    });
}

}  // namespace aips
