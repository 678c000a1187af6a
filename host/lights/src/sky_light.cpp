// Light of the clear sky.
#include "sky_light.h"

#include <cmath>

#include "warp.h"

namespace lxs {
namespace {

constexpr std::size_t kSide = 128;  // cells of the importance grid, each way

/// Direction of a point of the unit square; equal areas are equal solid angles.
Vec3 sky_direction(float x, float y) {
    const float height = 2 * y - 1;
    const float phi = 2 * kPi * x;
    const float sine = std::sqrt(std::max(0.0f, 1 - height * height));
    return Vec3(sine * std::cos(phi), sine * std::sin(phi), height);
}

/// Inverse of sky_direction for a unit direction.
Vec2 sky_coordinates(const Vec3& w) {
    const float s = std::atan2(w.y, w.x) / (2 * kPi);
    return Vec2(s < 0 ? s + 1 : s, (w.z + 1) / 2);
}

}  // namespace

SkyLight::SkyLight(const LightPlacement& placement, const SceneSphere& sphere,
                   const Rotation& rotation, const AnySky& model, float gain)
    : EnvironmentLight(placement, "sky", sphere), rotation_(rotation), model_(model), gain_(gain) {
    constexpr std::size_t kSub = 4;  // points a cell, each way
    std::vector<float> weights(kSide * kSide);
    Rgb fluence(0.0f);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        Rgb mean(0.0f);
        for (std::size_t k = 0; k < kSub * kSub; ++k) {
            constexpr auto kCells = static_cast<float>(kSide);
            const Vec2 center = grid_center(i, kSide);
            const Vec2 p = center + (grid_center(k, kSub) - Vec2(0.5f)) / kCells;
            mean += radiance(sky_direction(p.x, p.y)) / float(kSub * kSub);
        }
        weights[i] = luminance(mean);
        fluence += mean * (4 * kPi / (kSide * kSide));
    }
    importance_ = Piecewise2D(kSide, kSide, weights);
    set_fluence(fluence * gain_);
}

Rgb SkyLight::radiance(const Vec3& local) const {
    return std::visit([&](const auto& sky) { return sky.radiance(local); }, model_);
}

Rgb SkyLight::escaped(const Vec3& direction) const {
    return radiance(rotation_.to_local(direction)) * gain_;
}

bool SkyLight::sample_direction(const Vec2& u, SkyDirection& direction) const {
    if (!importance_.positive() || !(gain_ > 0)) return false;
    float density = 0;
    const Vec2 p = importance_.sample(u, density);
    const Vec3 local = sky_direction(p.x, p.y);
    direction.wi = rotation_.to_world(local).normalized();
    direction.radiance = radiance(local) * gain_;
    direction.pdf = density / (4 * kPi);
    direction.delta = false;
    return direction.pdf > 0;
}

float SkyLight::direction_density(const Vec3& wi) const {
    if (!(gain_ > 0)) return 0;
    return importance_.density(sky_coordinates(rotation_.to_local(wi))) / (4 * kPi);
}

bool SkyLight::direction_coordinates(const Vec3& wi, Vec2& u) const {
    return importance_.coordinates(sky_coordinates(rotation_.to_local(wi)), u);
}

}  // namespace lxs
