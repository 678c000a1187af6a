// Light at a point whose intensity depends on direction by an image.
#include "profile_light.h"

#include <cmath>

#include "warp.h"

namespace lxs {

ProfileLight::ProfileLight(const LightPlacement& placement, std::string_view kind,
                           const Vec3& position, const Rgb& intensity,
                           std::unique_ptr<const EmissionProfile> profile)
    : PlacedLight(placement),
      kind_(kind),
      position_(position),
      intensity_(intensity),
      profile_(std::move(profile)),
      power_(luminance(intensity_ * profile_->integral())) {}

bool ProfileLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    sample.normal = Vec3(0.0f);
    sample.ray = Ray{};
    sample.ray.origin = position_;
    sample.ray.media = media();
    const float density = profile_->sample(rounded_pair(u, 2), sample.ray.direction);
    if (!(density > 0)) return false;
    sample.power = intensity_ * profile_->at(sample.ray.direction) / density;
    return !is_black(sample.power);
}

bool ProfileLight::sample_direct(const Vec3& p, const Vec3& /*n*/, const Vec2& /*u*/,
                                 DirectSample& sample) const {
    sample.pdf = 0;
    const Vec3 to_light = position_ - p;
    const float distance2 = to_light.length2();
    if (!(distance2 > 0)) return false;
    const float distance = std::sqrt(distance2);
    const Vec3 wi = to_light / distance;
    const Rgb arriving = intensity_ * profile_->at(-wi) / distance2;
    if (is_black(arriving) || !std::isfinite(max_component(arriving))) return false;
    sample = {wi, distance, position_, arriving, 1.0f, true};
    return true;
}

bool ProfileLight::emission_coordinates(const Vec3& p, const DirectSample& /*sample*/,
                                        PrimaryPoint& u) const {
    const Vec3 w = (p - position_).normalized();
    Vec2 d;
    if (!(w.length2() > 0) || is_black(intensity_ * profile_->at(w)) ||
        !profile_->coordinates(w, d)) {
        return false;
    }
    set_rounded_pair(u, 2, d);
    return true;
}

}  // namespace lxs
