// Light from all directions: constant, or an image sampled by importance.
#include "infinite_light.h"

#include <algorithm>
#include <cmath>

#include "warp.h"

namespace lxs {
namespace {

Vec2 map_coordinates(const Vec3& local) {
    const float s = std::atan2(local.y, local.x) / (2 * kPi);
    return Vec2(s < 0 ? s + 1 : s, std::acos(std::clamp(local.z, -1.0f, 1.0f)) / kPi);
}

/// Sine of the polar angle; kept above zero because densities per solid angle divide by it.
float polar_sine(float t) {
    constexpr float kLeast = 1e-7f;
    return std::max(std::sin(kPi * t), kLeast);
}

}  // namespace

ConstantEnvironment::ConstantEnvironment(LightPlacement placement, const SceneSphere& sphere,
                                         const Rgb& radiance)
    : EnvironmentLight(std::move(placement), "infinite", sphere), radiance_(radiance) {
    set_fluence(radiance_ * (4 * kPi));
}

bool ConstantEnvironment::sample_direction(const Vec2& u, SkyDirection& direction) const {
    direction = {uniform_sphere(u.x, u.y), radiance_, 1 / (4 * kPi), false};
    return !is_black(radiance_);
}

float ConstantEnvironment::direction_density(const Vec3& /*wi*/) const {
    return is_black(radiance_) ? 0 : 1 / (4 * kPi);
}

bool ConstantEnvironment::direction_coordinates(const Vec3& wi, Vec2& u) const {
    u = from_uniform_sphere(wi);
    return true;
}

MappedEnvironment::MappedEnvironment(LightPlacement placement, const SceneSphere& sphere,
                                     const Rotation& rotation, LatLongMap map, const Rgb& scale)
    : EnvironmentLight(std::move(placement), "infinite", sphere),
      rotation_(rotation),
      map_(std::move(map)),
      importance_(map_.importance()),
      scale_(scale) {
    set_fluence(map_.fluence() * scale_);
}

Rgb MappedEnvironment::escaped(const Vec3& direction) const {
    return map_.lookup(map_coordinates(rotation_.to_local(direction))) * scale_;
}

bool MappedEnvironment::sample_direction(const Vec2& u, SkyDirection& direction) const {
    if (!importance_.positive()) return false;
    float density = 0;
    const Vec2 st = importance_.sample(u, density);
    const float phi = 2 * kPi * st.x, sine = polar_sine(st.y);
    const Vec3 local(sine * std::cos(phi), sine * std::sin(phi), std::cos(kPi * st.y));
    direction.wi = rotation_.to_world(local).normalized();
    direction.radiance = map_.lookup(st) * scale_;
    direction.pdf = density / (2 * kPi * kPi * sine);
    direction.delta = false;
    return direction.pdf > 0;
}

float MappedEnvironment::direction_density(const Vec3& wi) const {
    const Vec2 st = map_coordinates(rotation_.to_local(wi));
    return importance_.density(st) / (2 * kPi * kPi * polar_sine(st.y));
}

bool MappedEnvironment::direction_coordinates(const Vec3& wi, Vec2& u) const {
    return importance_.coordinates(map_coordinates(rotation_.to_local(wi)), u);
}

}  // namespace lxs
