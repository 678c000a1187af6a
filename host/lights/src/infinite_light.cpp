// Light from all directions: constant, or an image sampled by importance.
#include "infinite_light.h"

#include "latlong_coordinates.h"
#include "warp.h"

namespace lxs {
ConstantEnvironment::ConstantEnvironment(const LightPlacement& placement, const SceneSphere& sphere,
                                         const Rgb& radiance)
    : EnvironmentLight(placement, "infinite", sphere), radiance_(radiance) {
    set_fluence(radiance_ * (4 * kPi));
}

bool ConstantEnvironment::sample_direction(const Vec2& u, SkyDirection& direction) const {
    direction = {uniform_sphere(double(u.x), u.y), radiance_, 1 / (4 * kPi), false};
    return !is_black(radiance_);
}

float ConstantEnvironment::direction_density(const Vec3& /*wi*/) const {
    return is_black(radiance_) ? 0 : 1 / (4 * kPi);
}

bool ConstantEnvironment::direction_coordinates(const Vec3& wi, Vec2& u) const {
    const Vec2 found(from_uniform_sphere(wi));
    u = Vec2(clamp_to_unit(found.x), found.y);
    return true;
}

MappedEnvironment::MappedEnvironment(const LightPlacement& placement, const SceneSphere& sphere,
                                     const Rotation& rotation, LatLongMap map, const Rgb& scale)
    : EnvironmentLight(placement, "infinite", sphere),
      rotation_(rotation),
      map_(std::move(map)),
      importance_(map_.importance()),
      scale_(scale) {
    set_fluence(map_.fluence() * scale_);
}

Rgb MappedEnvironment::escaped(const Vec3& direction) const {
    return map_.lookup(latlong_coordinates(rotation_.to_local(direction))) * scale_;
}

bool MappedEnvironment::sample_direction(const Vec2& u, SkyDirection& direction) const {
    if (!importance_.positive()) return false;
    float density = 0;
    const Vec2 st = importance_.sample(u, density);
    direction.wi = rotation_.to_world(latlong_direction(st)).normalized();
    direction.radiance = map_.lookup(st) * scale_;
    direction.pdf = latlong_density(density, st.y);
    direction.delta = false;
    return direction.pdf > 0;
}

float MappedEnvironment::direction_density(const Vec3& wi) const {
    const Vec2 st = latlong_coordinates(rotation_.to_local(wi));
    return latlong_density(importance_.density(st), st.y);
}

bool MappedEnvironment::direction_coordinates(const Vec3& wi, Vec2& u) const {
    return importance_.coordinates(latlong_coordinates(rotation_.to_local(wi)), u);
}

}  // namespace lxs
