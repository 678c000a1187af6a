// Ellipses of emitters.
#include "emitter_paths/emitter_ellipse.h"

#include <algorithm>
#include <utility>

#include "aips/core/sampling/low_discrepancy.h"
#include "aips/core/sampling/random.h"

namespace aips {
namespace {

/// Points of an emitter that tell how large its image is.
constexpr unsigned kEmitterPoints = 16;

/// Half axes of an image (standard deviations of the points of the emitter).
constexpr double kImageSize = 2.7;

}  // namespace

bool sample_emitter(const Scene& scene, LightIndex light, const SurfacePoint& from, Vec2 u,
                    DirectSample& sample) {
    return scene.lights()[light]->sample_direct(from, u, sample) && !sample.delta &&
           sample.pdf > 0 && std::isfinite(sample.pdf) && is_finite(sample.wi);
}

EmitterImage emitter_ellipse(const EyePassInput& in, LightIndex light, const ChainVertex& end,
                             const Derivative& derivative, const Frame& frame, Plane at) {
    Plane sum, squares;
    double products = 0, points = 0;
    for (unsigned i = 0; i < kEmitterPoints; ++i) {
        DirectSample sample;
        const Vec2 u{(float(i) + 0.5f) / kEmitterPoints, to_unit_float(reverse_bits(i))};
        if (!sample_emitter(in.scene, light, end.point, u, sample)) continue;
        const Plane p = derivative.step_for(difference(frame, sample.wi, end.direction));
        sum = {sum.x + p.x, sum.y + p.y};
        squares = {squares.x + p.x * p.x, squares.y + p.y * p.y};
        products += p.x * p.y;
        points += 1;
    }
    EmitterImage image;
    if (points == 0) return image;
    const Plane mean{sum.x / points, sum.y / points};
    const double least = least_difference(in) * least_difference(in);
    const double xx = squares.x / points - mean.x * mean.x + least;
    const double yy = squares.y / points - mean.y * mean.y + least;
    const double xy = products / points - mean.x * mean.y;
    // The root of the covariance that is a lower triangle (Cholesky).
    const double a = std::sqrt(xx), b = xy / a, c = std::sqrt(std::max(yy - b * b, least));
    image.centre = {float(at.x + mean.x), float(at.y + mean.y)};
    image.axes = {float(kImageSize * a), 0, float(kImageSize * b), float(kImageSize * c)};
    return image;
}

}  // namespace aips
