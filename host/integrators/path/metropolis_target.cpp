// An eye path as a function of its point in primary sample space.
#include "path/metropolis_target.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lxs {
namespace {

/// Keeps rounding from lifting a position onto the film's far border.
float on_film(float u, std::uint32_t size) {
    const auto end = static_cast<float>(size);
    return std::min(u * end, std::nextafter(end, 0.0f));
}

}  // namespace

PathTarget::PathTarget(const RenderContext& context, const PathTracer& tracer,
                       std::vector<aips::LightSample>* told)
    : context_(context),
      tracer_(tracer),
      told_(told),
      buffer_(context.scene.facts().max_bsdf_bytes + alignof(std::max_align_t)),
      memory_(buffer_.data(), buffer_.size()) {}

void PathTarget::evaluate(PrimarySample& sample, Contribution& contribution) {
    const Vec2 film = sample.next_2d();
    const Vec2 lens = sample.next_2d();
    const float open = context_.camera.shutter_open();
    const float time = open + (context_.camera.shutter_close() - open) * sample.next();
    contribution.position = {on_film(film.x, context_.film.width()),
                             on_film(film.y, context_.film.height())};
    contribution.radiance.assign(context_.film.light_groups(), Rgb(0.0f));
    PathResult result{.radiance = contribution.radiance, .told = told_};
    const CameraRay camera = context_.camera.generate({contribution.position, lens}, time);
    tracer_.trace(camera.ray, sample, memory_, result);

    contribution.brightness = 0;
    for (const Rgb& radiance : contribution.radiance)
        contribution.brightness += std::min(luminance(radiance), std::numeric_limits<float>::max());
    counts_ += {1, result.rays, result.bounces};
}

}  // namespace lxs
