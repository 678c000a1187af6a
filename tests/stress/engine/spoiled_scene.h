// A mock scene of which one part gives values that no host ought to give.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "mock_scene.h"

namespace mock {

/// What is spoiled: of one surface, of one light, or of what light passes.
enum class Part {
    BsdfValue,
    BsdfPdf,
    BsdfWeight,
    BsdfAlbedo,
    BsdfDirection,
    LambertReflectance,
    SurfacePosition,
    SurfaceDistance,
    GeometricNormal,
    ShadingNormal,
    Emitted,
    LightPower,
    LightOrigin,
    LightDirection,
    DirectRadiance,
    DirectPdf,
    DirectDirection,
    PdfDirect,
    Escaped,
    EmissionCoordinates,
    LightsOwnPower,
    Transmittance,
    Visibility,
};

std::string_view name(Part part);

/// Which part, of which surface or light, and what is given in its place.
struct Spoil {
    Part part = Part::BsdfValue;
    std::uint32_t index = 0;
    float value = 0;
};

/// `scene` with one part spoiled. The surface's point is found by its material, its light by its
/// place in Scene::lights(). `scene` outlives this.
class SpoiledScene final : public aips::Scene {
  public:
    SpoiledScene(const Scene& scene, const Spoil& spoil);
    ~SpoiledScene() override;

    bool intersect(const aips::Ray& ray, aips::SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override;
    aips::Ray spawn(const aips::SurfacePoint& point, aips::Vec3 direction,
                    float time) const override {
        return scene_.spawn(point, direction, time);
    }
    aips::Rgb visibility(const aips::SurfacePoint& point, const aips::DirectSample& light,
                         float time) const override;
    std::span<const aips::Light* const> lights() const override { return lights_; }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override { return scene_.light_groups(); }
    aips::Bounds bounds() const override { return scene_.bounds(); }
    aips::SceneFacts facts() const override;

  private:
    const Scene& scene_;
    Spoil spoil_;
    std::unique_ptr<aips::Light> spoiled_light_;
    std::vector<const aips::Light*> lights_;
};

}  // namespace mock
