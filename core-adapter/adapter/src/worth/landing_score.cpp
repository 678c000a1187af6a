// Scores of landings.
#include "worth/landing_score.h"

#include "aips/core/sampling/sampling.h"
#include "base/parallel_for.h"
#include "estimate/gather.h"

namespace aips {

void LandingScore::build(const EyeImage& image, std::span<const Vec3> positions,
                         const SearchRadii& radii, std::span<const float> weights) {
    image_ = &image;
    radii_ = radii;
    weights_ = weights;
    cells_.build(positions, radii.largest, tbb_for);
}

double LandingScore::score(const Landing& landing) const {
    const GridPhoton photon = grid_photon(landing, 0);
    double sum = 0;
    cells_.for_each_in_radius(landing.position, radii_.largest, [&](std::uint32_t slot) {
        const std::uint32_t i = cells_.order()[slot];
        const VisiblePoint& point = image_->visible_points[i];
        const float radius = radii_.of(i);
        if (length_squared(point.position - landing.position) > radius * radius) return;
        const Rgb f = left_out_f(point);
        const double value =
            double(luminance(point.throughput * f * contribution(point, photon, radius)));
        if (!(value > 0) || !std::isfinite(value)) return;
        sum +=
            double(weights_[i]) * value * value / (double(kPi) * double(radius) * double(radius));
    });
    const auto points = double(image_->visible_points.size());
    return points > 0 && std::isfinite(sum) ? sum / points : 0;
}

}  // namespace aips
