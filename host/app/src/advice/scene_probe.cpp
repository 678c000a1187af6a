// Rays that advice asks the scene with.
#include "advice/scene_probe.h"

#include <cmath>

#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr std::uint32_t kProbesPerAxis = 24;
constexpr std::uint32_t kSpecularEvery = 2;  ///< of so many of these rays one passes through all
constexpr int kMostPassed = 32;              ///< surfaces on one ray
constexpr int kAround = 64;                  ///< ways from a place

}  // namespace

/// splitmix64 (Steele, Lea and Flood 2014).
float ProbeNumbers::next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
}

SpecularSurface specular_surface(const MetSurface& met) {
    SpecularSurface surface;
    if (!met.hit.bsdf || met.hit.bsdf->lobes() != kSpecular) return surface;
    constexpr int kDraws = 16;
    for (int i = 0; i < kDraws; ++i) {
        BsdfSample sample;
        const float u = (static_cast<float>(i) + 0.5f) / kDraws;
        if (!met.hit.bsdf->sample(-met.ray.direction, Vec2(0.5f), u, Transport::Radiance, kSpecular,
                                  sample) ||
            is_black(sample.weight))
            continue;
        surface.passes_straight |= sample.transmitted && sample.straight;
        surface.refracts |= sample.transmitted && !sample.straight;
        surface.reflects |= !sample.transmitted;
    }
    return surface;
}

SceneProbe::SceneProbe(const RenderSession& session)
    : scene_(*session.scene), time_(session.camera->shutter_open()) {
    const auto offset = [](std::uint32_t i) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(kProbesPerAxis);
    };
    const auto width = static_cast<float>(session.film->width());
    const auto height = static_cast<float>(session.film->height());
    for (std::uint32_t number = 0; number < kProbesPerAxis * kProbesPerAxis; ++number) {
        const Vec2 place(offset(number % kProbesPerAxis) * width,
                         offset(number / kProbesPerAxis) * height);
        MetSurface met;
        met.ray = session.camera->generate({place, Vec2(0.5f)}, time_).ray;
        eye_ += met.ray.origin;
        view_ += met.ray.direction;
        if (scene_.intersect(met.ray, met.hit, kept_)) seen_.push_back(met);
    }
    eye_ /= static_cast<float>(kProbesPerAxis * kProbesPerAxis);
    view_.normalize();
    if (!scene_.facts().has_specular) return;
    for (std::size_t i = 0; i < seen_.size(); i += kSpecularEvery) {
        pass_through(seen_[i].ray, [&](const MetSurface& met) {
            if (!met.hit.bsdf || met.hit.bsdf->lobes() != kSpecular) return true;
            MetSurface again = met;
            if (scene_.intersect(met.ray, again.hit, kept_)) specular_.push_back(again);
            return true;
        });
    }
}

std::optional<MetSurface> SceneProbe::meet(const Ray& ray) {
    passing_.release();
    if (!std::isfinite(ray.origin.length2()) || !(ray.direction.length2() > 0.5f)) return {};
    MetSurface met{ray, {}};
    if (!scene_.intersect(ray, met.hit, passing_)) return {};
    return met;
}

void SceneProbe::pass_through(Ray ray, const std::function<bool(const MetSurface&)>& visit) {
    for (int i = 0; i < kMostPassed; ++i) {
        const auto met = meet(ray);
        if (!met || !visit(*met)) return;
        ray = spawn_ray(met->hit, ray.direction, time_);
    }
}

std::optional<std::uint32_t> SceneProbe::solid_around(const Vec3& from) {
    std::optional<std::uint32_t> material;
    for (int i = 0; i < kAround; ++i) {
        Ray ray;
        ray.origin = from;
        ray.direction = direction_on_sphere(i, kAround);
        ray.time = time_;
        const auto met = meet(ray);
        if (!met || !from_behind(ray, met->hit)) return {};
        if (material && *material != met->hit.material) return {};
        material = met->hit.material;
    }
    return material;
}

bool SceneProbe::sees_eye(const MetSurface& from) const {
    const Vec3 to_eye = eye_ - from.hit.p;
    // What passes to the other side walks on there.
    if (to_eye.dot(from.hit.ng) * from.ray.direction.dot(from.hit.ng) >= 0) return false;
    Ray ray = spawn_ray(from.hit, to_eye.normalized(), time_);
    ray.t_max = to_eye.length();
    return max_component(scene_.transmittance(ray)) > 0;
}

}  // namespace lxs
