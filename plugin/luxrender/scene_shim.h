// LuxRender's scene and lights as the engine sees them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aips/adapter/scene.h"
#include "lux_view.h"
#include "pass_wavelengths.h"

namespace aips::luxrender {

/// Volumes may absorb and refract; those that scatter are refused before.
class SceneShim final : public Scene {
  public:
    /// Measures the lights' power, for which it sets wavelengths.
    SceneShim(LuxView& view, const PassWavelengths& wavelengths);
    ~SceneShim() override;

    bool intersect(const Ray& ray, SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override;
    bool intersect_shape(const Ray& ray, SurfacePoint& point,
                         std::pmr::memory_resource& memory) const override;
    Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const override;
    Rgb visibility(const SurfacePoint& point, const DirectSample& light, float time) const override;
    std::span<const Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> material_names() const override { return material_names_; }
    std::uint32_t light_groups() const override { return view_.light_groups(); }
    Bounds bounds() const override;
    SceneFacts facts() const override;

  private:
    const LuxView& view_;
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<const Light*> light_pointers_;
    std::vector<std::string> material_names_;
};

}  // namespace aips::luxrender
