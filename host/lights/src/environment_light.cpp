// Base of lights at infinity: photons start on a disk beside the scene's sphere.
#include "environment_light.h"

#include <cmath>

#include "warp.h"

namespace lxs {

EnvironmentLight::EnvironmentLight(LightPlacement placement, std::string_view kind,
                                   const SceneSphere& sphere)
    : placement_(std::move(placement)), kind_(kind), sphere_(sphere) {
    if (!(sphere_.radius > 0) || !std::isfinite(sphere_.radius)) sphere_ = SceneSphere{};
}

void EnvironmentLight::set_fluence(const Rgb& fluence) {
    power_ = kPi * sphere_.radius * sphere_.radius * luminance(fluence);
}

bool EnvironmentLight::sample_emission(const std::array<float, 4>& u,
                                       EmissionSample& sample) const {
    SkyDirection sky;
    if (!sample_direction(Vec2(u[2], u[3]), sky)) return false;
    const Vec2 d = square_to_concentric_disk(Vec2(u[0], u[1]));
    const Frame frame(sky.wi);
    // A little beyond the sphere, so that rounding puts no surface behind the origin.
    constexpr float kBeyond = 1.01f;
    // A medium begins on the sphere.
    const float ahead = placement_.medium ? std::sqrt(std::max(0.0f, 1 - d.length2())) : kBeyond;
    sample.ray = Ray{};
    sample.ray.origin =
        sphere_.center + (frame.s * d.x + frame.t * d.y + sky.wi * ahead) * sphere_.radius;
    sample.ray.direction = -sky.wi;
    sample.ray.medium = placement_.medium.get();
    sample.power = sky.radiance * (kPi * sphere_.radius * sphere_.radius / sky.pdf);
    sample.normal = Vec3(0.0f);
    return !is_black(sample.power);
}

bool EnvironmentLight::sample_direct(const Vec3& /*p*/, const Vec3& /*n*/, const Vec2& u,
                                     DirectSample& sample) const {
    SkyDirection sky;
    sample.pdf = 0;
    if (!sample_direction(u, sky)) return false;
    sample = {sky.wi,   std::numeric_limits<float>::infinity(), Vec3(0.0f), sky.radiance, sky.pdf,
              sky.delta};
    return true;
}

bool EnvironmentLight::emission_coordinates(const Vec3& p, const DirectSample& sample,
                                            std::array<float, 4>& u) const {
    Vec2 direction(u[2], u[3]);
    SkyDirection sky;
    if (!direction_coordinates(sample.wi, direction)) return false;
    // The start is found for the direction of the rounded coordinates, so that the ray meets p.
    if (!sample_direction(direction, sky) || is_black(sky.radiance)) return false;
    const Vec3 offset = Frame(sky.wi).to_local((p - sphere_.center) / sphere_.radius);
    const Vec2 on_disk(offset.x, offset.y);
    if (!(on_disk.length2() <= 1)) return false;
    const Vec2 start = concentric_disk_to_square(on_disk);
    u = {start.x, start.y, direction.x, direction.y};
    return true;
}

}  // namespace lxs
