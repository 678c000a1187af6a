// Lights at a point: isotropic, and spot with a falloff.
#include "point_light.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

float one_minus_cos(float angle) {
    const float s = std::sin(angle / 2);
    return 2 * s * s;
}

}  // namespace

bool PointLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    sample.power = intensity_ * falloff_integral();
    sample.normal = Vec3(0.0f);
    sample.ray = Ray{};
    sample.ray.origin = position_;
    sample.ray.direction = sample_direction(u[2], rounded_pair(u, 2).y);
    sample.ray.media = media();
    return !is_black(sample.power);
}

bool PointLight::sample_direct(const Vec3& p, const Vec3& /*n*/, const Vec2& /*u*/,
                               DirectSample& sample) const {
    sample.pdf = 0;
    const Vec3 to_light = position_ - p;
    const float distance2 = to_light.length2();
    if (!(distance2 > 0)) return false;
    const float distance = std::sqrt(distance2);
    const Vec3 wi = to_light / distance;
    const float share = falloff(-wi);
    const float scale = share / distance2;
    if (!(scale > 0) || !std::isfinite(scale * max_component(intensity_))) return false;
    sample = {wi, distance, position_, intensity_ * scale, 1.0f, true};
    return true;
}

bool PointLight::emission_coordinates(const Vec3& p, const DirectSample& /*sample*/,
                                      PrimaryPoint& u) const {
    const Vec3 w = (p - position_).normalized();
    if (is_black(intensity_) || !(w.length2() > 0) || !(falloff(w) > 0)) return false;
    const Imath::V2d found = direction_coordinates(w);
    const double before = u[2];
    set_rounded_pair(u, 2, Vec2(found));
    // Finer there, see uniform_sphere().
    if (found.x > 0.5)
        u[2] = clamp_to_unit(1.0 - (1.0 - found.x) * (1.0 + 0x1p-24 * (before - 0.5)));
    return true;
}

SpotLight::SpotLight(const LightPlacement& placement, const Vec3& position, const Vec3& axis,
                     const Rgb& intensity, const SpotCone& cone)
    : PointLight(placement, position, intensity),
      frame_(axis),
      inner_(one_minus_cos(cone.inner)),
      outer_(one_minus_cos(cone.outer)),
      smooth_(cone.smooth) {}

float SpotLight::fall(float share) const {
    return smooth_ ? share * share * (3 - 2 * share) : (share * share) * (share * share);
}

float SpotLight::fallen(float share) const {
    return smooth_ ? share * share * share * (2 - share) : std::pow(share, 5.0f);
}

float SpotLight::share_of(float fallen) const {
    if (!smooth_) return std::pow(fallen, 0.2f);
    double share = std::cbrt(fallen / 2);  // below the root, where Newton's steps rise to it
    for (int i = 0; i < 6; ++i) {
        const double slope = share * share * (6 - 4 * share);
        if (!(slope > 0)) break;
        share -= (share * share * share * (2 - share) - double(fallen)) / slope;
    }
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

float SpotLight::falloff(const Vec3& w) const {
    const float x = (w - frame_.n).length2() / 2;  // 1 - cosine of unit vectors
    if (x >= outer_) return 0;
    if (x <= inner_) return 1;
    return fall((outer_ - x) / (outer_ - inner_));
}

float SpotLight::falloff_integral() const {
    return 2 * kPi * (inner_ + fade());
}

Vec3 SpotLight::sample_direction(double u0, float u1) const {
    const float target = static_cast<float>(u0) * (inner_ + fade());
    float x = target;
    if (target > inner_) {
        const float rest = std::clamp(1.0f - (target - inner_) / fade(), 0.0f, 1.0f);
        x = outer_ - (outer_ - inner_) * share_of(rest);
    }
    return frame_.to_world(around_z(x, u1)).normalized();
}

Imath::V2d SpotLight::direction_coordinates(const Vec3& w) const {
    const Vec2 polar = from_around_z(frame_.to_local(w));
    float target = polar.x;
    if (target > inner_) {
        const float rest = std::clamp((outer_ - target) / (outer_ - inner_), 0.0f, 1.0f);
        target = inner_ + fade() * (1.0f - fallen(rest));
    }
    return Imath::V2d(Vec2(clamp_to_unit(target / (inner_ + fade())), polar.y));
}

}  // namespace lxs
