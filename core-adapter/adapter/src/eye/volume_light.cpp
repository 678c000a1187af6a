// Next-event estimation on a segment within a medium.
#include "eye/volume_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace aips {
namespace {

/// Least distance of a light from a beam whose points are drawn by the angle at which the light
/// sees them (share of the beam's length).
constexpr float kLeastPivotShare = 1e-4f;

/// Distance of a light from which on all of a beam is seen alike, and angles cancel in rounding
/// (lengths of the beam).
constexpr float kFarLengths = 64;

/// Density of distances by the angle at which a segment is seen from a point beside it (Kulla &
/// Fajardo 2012, eq. 5-7).
class Equiangular {
  public:
    Equiangular(const VolumeBeam& beam, Vec3 pivot)
        : nearest_(dot(pivot - beam.origin, beam.direction)) {
        height_ = std::max(length(pivot - beam.at(nearest_)), kLeastPivotShare * beam.length);
        first_ = std::atan(-nearest_ / height_);
        last_ = std::atan((beam.length - nearest_) / height_);
    }
    float sample(float u) const {
        return nearest_ + height_ * std::tan(first_ + u * (last_ - first_));
    }
    float pdf(float t) const {
        const float beside = t - nearest_;
        return height_ / ((last_ - first_) * (height_ * height_ + beside * beside));
    }

  private:
    float nearest_, height_ = 0, first_ = 0, last_ = 0;
};

/// What lights take for the point that they are asked to light.
SurfacePoint point_in_medium(Vec3 position) {
    SurfacePoint point;
    point.position = position;
    return point;
}

/// A place on the light, if it has one.
std::optional<Vec3> pivot_of(const Light& light, const VolumeBeam& beam, Vec2 u) {
    const SurfacePoint middle = point_in_medium(beam.at(0.5f * beam.length));
    DirectSample sample;
    if (!light.sample_direct(middle, u, sample) || !std::isfinite(sample.distance)) return {};
    if (sample.distance > kFarLengths * beam.length) return {};
    return middle.position + sample.wi * sample.distance;
}

struct Distance {
    float t = 0;
    float pdf = 0;
};

Distance sample_distance(const VolumeBeam& beam, const SegmentExponential& by_transmittance,
                         const std::optional<Vec3>& pivot, float u) {
    if (!pivot) {
        const float t = by_transmittance.sample(u);
        return {t, by_transmittance.pdf(t)};
    }
    const Equiangular by_angle(beam, *pivot);
    const float drawn = u < 0.5f ? by_angle.sample(2 * u) : by_transmittance.sample(2 * u - 1);
    const float t = std::clamp(drawn, 0.0f, beam.length);
    return {t, 0.5f * (by_angle.pdf(t) + by_transmittance.pdf(t))};
}

}  // namespace

unsigned estimate_scattered_light(const Scene& scene, const DirectLight& lights,
                                  const VolumeBeam& beam, float time, const SegmentNumbers& u,
                                  InvalidSampleFilter& filter, const ScatteredLightOutput& output) {
    if (lights.choice().empty() || !(beam.length > 0)) return 0;
    const Media& media = *scene.media();
    const Rgb extinction = media.extinction(beam.medium);
    const Rgb scattering = media.scattering(beam.medium);
    const DiscreteSample chosen = lights.choice().sample(u.light_choice());
    const Light& light = *scene.lights()[chosen.index];
    // The place on the light that the distance is drawn for is the one that is then asked: for each
    // such place the estimate is right.
    const auto pivot = pivot_of(light, beam, u.light());
    const Distance distance = sample_distance(
        beam, SegmentExponential(extinction, scattering, beam.length), pivot, u.distance());
    const Vec3 position = beam.at(distance.t);
    DirectSample sample;
    if (!light.sample_direct(point_in_medium(position), u.light(), sample) ||
        !filter.accept_sample(sample, static_cast<LightIndex>(chosen.index)) || sample.pdf == 0 ||
        is_black(sample.radiance)) {
        return 0;
    }
    Rgb reached;
    media.transmittances(beam.medium, beam.ray(), {&distance.t, 1}, u.collisions(), {&reached, 1});
    const Rgb scattered = beam.throughput * reached * media.scattering_at(beam.medium, position) *
                          media.phase(beam.medium, dot(beam.direction, sample.wi));
    const Rgb unoccluded =
        scattered * sample.radiance * (1 / (distance.pdf * sample.pdf * chosen.pdf));
    if (!filter.accept(unoccluded, kPassageOrigin) || is_black(unoccluded)) return 0;
    const Rgb passed = media.visibility(beam.medium, position, sample, time);
    if (output.radiance.add(light.group(), unoccluded * passed, kPassageOrigin, filter))
        tell(output.light, LightIndex(chosen.index), luminance(unoccluded * passed));
    return 1;
}

}  // namespace aips
