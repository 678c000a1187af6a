// Radii of mode=ppm.
#include "radii/ppm_radius.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "aips/core/radii/ppm_statistics.h"

namespace aips {

GatherRadii PpmRadius::before_pass(const PassPhotons& /*photons*/, const EyeImage& image) {
    if (points_.empty()) {
        const double radius = initial_radius(settings_, image, floor_.least());
        points_.assign(image.visible_points.size(), {0, radius * radius});
        radii_.resize(points_.size());
    }
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        radii_[i] = std::max(float(std::sqrt(points_[i].squared_radius)),
                             floor_.at(image.visible_points[i].position));
    }
    return GatherRadii(std::span<const float>(radii_));
}

// The radii searched follow from their squares before each pass.
void PpmRadius::state(StateArchive& archive, const EyeImage& image) {
    bool begun = !points_.empty();
    archive.value(begun);
    if (!begun) return;
    archive.fixed_count(image.visible_points.size());
    if (archive.restoring()) {
        points_.resize(image.visible_points.size());
        radii_.resize(points_.size());
    }
    const double initial = initial_radius(settings_, image, floor_.least());
    for (Point& point : points_) {
        archive.amount(point.photons);
        archive.amount(point.squared_radius);
        StateArchive::check(point.squared_radius <= initial * initial,
                            "a gather radius that has grown");
    }
}

void PpmRadius::after_pass(const PhotonFlux& flux) {
    const double least = floor_.least() * floor_.least();
    tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
        Point& point = points_[i];
        const PpmStep step = ppm_step(point.photons, flux.accepted[i], settings_.alpha);
        point.photons = step.photons;
        point.squared_radius = std::max(point.squared_radius * step.share, least);
    });
}

}  // namespace aips
