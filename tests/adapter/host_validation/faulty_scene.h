// A mock scene in which something is spoilt on its way to the engine.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "aips/adapter/host_validation.h"
#include "render_mock.h"

namespace mock {

/// What is changed of a scene; the rest stays its own.
struct Spoils {
    std::function<void(aips::SurfacePoint&, std::pmr::memory_resource&)> point;
    std::function<void(aips::Ray&)> spawned;
    std::function<void(aips::SceneFacts&)> facts;
    /// In place of the scene's own.
    std::function<aips::Rgb(const aips::SurfacePoint&, const aips::DirectSample&)> visibility;
    std::optional<aips::Bounds> bounds;
};

class FaultyScene final : public aips::Scene {
  public:
    /// `scene` outlives this.
    FaultyScene(const Scene& scene, Spoils spoils)
        : scene_(scene),
          lights_(scene.lights().begin(), scene.lights().end()),
          spoils_(std::move(spoils)) {}
    void exchange_light(std::size_t number, const aips::Light& light) { lights_[number] = &light; }

    bool intersect(const aips::Ray& ray, aips::SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override {
        if (!scene_.intersect(ray, point, memory)) return false;
        if (spoils_.point) spoils_.point(point, memory);
        return true;
    }
    aips::Ray spawn(const aips::SurfacePoint& point, aips::Vec3 direction,
                    float time) const override {
        aips::Ray ray = scene_.spawn(point, direction, time);
        if (spoils_.spawned) spoils_.spawned(ray);
        return ray;
    }
    aips::Rgb visibility(const aips::SurfacePoint& point, const aips::DirectSample& light,
                         float time) const override {
        return spoils_.visibility ? spoils_.visibility(point, light)
                                  : scene_.visibility(point, light, time);
    }
    std::span<const aips::Light* const> lights() const override { return lights_; }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override { return scene_.light_groups(); }
    aips::Bounds bounds() const override {
        return spoils_.bounds ? *spoils_.bounds : scene_.bounds();
    }
    aips::SceneFacts facts() const override {
        aips::SceneFacts facts = scene_.facts();
        if (spoils_.facts) spoils_.facts(facts);
        return facts;
    }

  private:
    const Scene& scene_;
    std::vector<const aips::Light*> lights_;
    Spoils spoils_;
};

/// Findings, one line each: what tests show when they fail.
inline std::string lines(const std::vector<aips::HostFinding>& findings) {
    std::string text;
    for (const aips::HostFinding& finding : findings)
        text += to_string(finding) + '\n';
    return text;
}

/// A quarter of the samples and a fifth of the rays, for scenes whose faults are gross.
inline aips::HostValidationSettings quick_check() {
    aips::HostValidationSettings settings;
    settings.rays = 4000;
    settings.samples = 2048;
    settings.places = 2;
    return settings;
}

}  // namespace mock
