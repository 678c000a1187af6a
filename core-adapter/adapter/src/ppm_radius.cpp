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
        const double radius = initial_radius(settings_, image, smallest_);
        radii_.assign(image.visible_points.size(), float(radius));
        points_.assign(image.visible_points.size(), {0, radius * radius});
    }
    SearchRadii radii;
    radii.largest = *std::max_element(radii_.begin(), radii_.end());
    radii.mean = float(std::accumulate(radii_.begin(), radii_.end(), 0.0) / double(radii_.size()));
    radii.per_point = radii_;
    return radii;
}

// Saved between passes, when the radii searched follow from their squares.
void PpmRadius::state(StateArchive& archive, const EyeImage& image) {
    bool begun = !points_.empty();
    archive.value(begun);
    if (!begun) return;
    archive.fixed_count(image.visible_points.size());
    if (archive.restoring()) {
        points_.resize(image.visible_points.size());
        radii_.resize(points_.size());
    }
    const double initial = initial_radius(settings_, image, smallest_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        Point& point = points_[i];
        archive.amount(point.photons);
        archive.amount(point.squared_radius);
        StateArchive::check(point.squared_radius <= initial * initial,
                            "a search radius that has grown");
        radii_[i] = float(std::sqrt(point.squared_radius));
    }
}

void PpmRadius::after_pass(const PhotonFlux& flux) {
    tbb::parallel_for(std::size_t{0}, radii_.size(), [&](std::size_t i) {
        Point& point = points_[i];
        const PpmStep step = ppm_step(point.photons, flux.accepted[i], settings_.alpha);
        point.photons = step.photons;
        point.squared_radius = std::max(point.squared_radius * step.share, smallest_ * smallest_);
        radii_[i] = float(std::sqrt(point.squared_radius));
    });
}

}  // namespace aips
