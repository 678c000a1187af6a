// Lights at infinity around one direction: a single direction, or a cone of constant radiance.
#include "directional_light.h"

#include <cmath>

namespace lxs {

ParallelLight::ParallelLight(const LightPlacement& placement, const SceneSphere& sphere,
                             const Vec3& wi, const Rgb& irradiance)
    : EnvironmentLight(placement, "distant", sphere), wi_(wi), irradiance_(irradiance) {
    set_fluence(irradiance_, wi_);
}

bool ParallelLight::sample_direction(const Vec2& /*u*/, SkyDirection& direction) const {
    direction = {wi_, irradiance_, 1.0f, true};
    return !is_black(irradiance_);
}

ConeLight::ConeLight(const LightPlacement& placement, std::string_view kind,
                     const SceneSphere& sphere, const Vec3& axis, float sin_max,
                     const Rgb& radiance)
    : EnvironmentLight(placement, kind, sphere),
      frame_(axis),
      extent_(solid_angle(sin_max) / (2 * kPi)),
      radiance_(radiance) {
    set_fluence(radiance_ * solid_angle(sin_max), axis);
}

float ConeLight::solid_angle(float sin_max) {
    const float sin2 = sin_max * sin_max;
    return 2 * kPi * sin2 / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sin2)));
}

bool ConeLight::sample_direction(const Vec2& u, SkyDirection& direction) const {
    if (is_black(radiance_)) return false;
    direction.wi = frame_.to_world(around_z(u.x * extent_, u.y)).normalized();
    direction.radiance = radiance_;
    direction.pdf = 1.0f / (2 * kPi * extent_);
    direction.delta = false;
    return true;
}

bool ConeLight::direction_coordinates(const Vec3& wi, Vec2& u) const {
    if (!inside(wi)) return false;
    const Vec2 polar = from_around_z(frame_.to_local(wi));
    u = Vec2(clamp_to_unit(polar.x / extent_), polar.y);
    return true;
}

}  // namespace lxs
