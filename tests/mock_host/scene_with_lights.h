// A mock scene whose lights are exchanged: for lights that the mock host does not have.
#pragma once

#include <vector>

#include "mock_scene.h"

namespace mock {

/// All but the lights is the scene's own. Light indices of its surfaces stay valid as long as the
/// first lights are still theirs.
class SceneWithLights final : public aips::Scene {
  public:
    /// `scene` and the lights outlive this.
    SceneWithLights(const Scene& scene, std::vector<const aips::Light*> lights)
        : scene_(scene), lights_(std::move(lights)) {}

    bool intersect(const aips::Ray& ray, aips::SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override {
        return scene_.intersect(ray, point, memory);
    }
    aips::Ray spawn(const aips::SurfacePoint& point, aips::Vec3 direction,
                    float time) const override {
        return scene_.spawn(point, direction, time);
    }
    aips::Rgb visibility(const aips::SurfacePoint& point, const aips::DirectSample& light,
                         float time) const override {
        return scene_.visibility(point, light, time);
    }
    std::span<const aips::Light* const> lights() const override { return lights_; }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override { return scene_.light_groups(); }
    aips::Bounds bounds() const override { return scene_.bounds(); }
    aips::SceneFacts facts() const override { return scene_.facts(); }

  private:
    const Scene& scene_;
    std::vector<const aips::Light*> lights_;
};

/// Everything that another light does; tests override a part of it.
class LightLike : public aips::Light {
  public:
    explicit LightLike(const aips::Light& light) : light_(light) {}
    std::uint32_t group() const override { return light_.group(); }
    float power() const override { return light_.power(); }
    bool at_infinity() const override { return light_.at_infinity(); }
    bool hidden_from_camera() const override { return light_.hidden_from_camera(); }
    bool is_delta() const override { return light_.is_delta(); }
    bool emit(const aips::PrimaryPoint& u, aips::Emission& emission) const override {
        return light_.emit(u, emission);
    }
    bool sample_direct(const aips::SurfacePoint& from, aips::Vec2 u,
                       aips::DirectSample& sample) const override {
        return light_.sample_direct(from, u, sample);
    }
    float pdf_direct(const aips::SurfacePoint& from, aips::Vec3 wi,
                     const aips::SurfacePoint* at) const override {
        return light_.pdf_direct(from, wi, at);
    }
    aips::Rgb escaped(aips::Vec3 direction) const override { return light_.escaped(direction); }

  private:
    const aips::Light& light_;
};

}  // namespace mock
