// Scores of photons.
#include "contribution/photon_score.h"

#include "aips/core/sampling/sampling.h"
#include "base/parallel_for.h"
#include "estimate/gather.h"

namespace aips {

void PhotonScore::build(const EyeImage& image, std::span<const Vec3> positions,
                        const GatherRadii& radii, std::span<const float> weights) {
    image_ = &image;
    radii_ = radii;
    weights_ = weights;
    cells_.build(positions, radii.largest, tbb_for);
}

double PhotonScore::term(std::size_t i, const GridPhoton& photon, float radius) const {
    const VisiblePoint& point = image_->visible_points[i];
    const Rgb f = left_out_f(point);
    const double value =
        double(luminance(point.throughput * f * contribution(point, photon, radius)));
    if (!(value > 0) || !std::isfinite(value)) return 0;
    return double(weights_[i]) * value * value / (double(kPi) * double(radius) * double(radius));
}

}  // namespace aips
