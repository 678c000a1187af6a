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

void PpmRadius::state(StateArchive& archive, const EyeImage& image) {
    bool begun = !radii_.empty();
    archive.value(begun);
    if (!begun) return;
    if (archive.restoring()) {
        radii_.resize(image.visible_points.size());
        photons_.resize(image.visible_points.size());
    }
    archive.fixed(radii_);
    archive.fixed(photons_);
    const auto initial = float(initial_radius(settings_, image, smallest_));
    for (std::size_t i = 0; i < radii_.size() && archive.restoring(); ++i) {
        StateArchive::check(radii_[i] >= 0 && radii_[i] <= initial,
                            "a search radius that has grown");
        StateArchive::check(photons_[i] >= 0 && std::isfinite(photons_[i]),
                            "a visible point with no number of photons");
    }
}

void PpmRadius::after_pass(const PhotonFlux& flux) {
    tbb::parallel_for(std::size_t{0}, radii_.size(), [&](std::size_t i) {
        const PpmStep step = ppm_step(photons_[i], flux.accepted[i], settings_.alpha);
        photons_[i] = step.photons;
        radii_[i] *= float(std::sqrt(step.share));
    });
}

}  // namespace aips
