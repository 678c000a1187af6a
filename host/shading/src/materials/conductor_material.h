// Rough metal with optical constants from a texture: "metal" and "metal2".
#pragma once

#include "lxs/scene/material.h"
#include "prepared_texture.h"
#include "rough_surface.h"

namespace lxs::shading {

class ConductorMaterial final : public Material {
  public:
    ConductorMaterial(PreparedFresnel fresnel, RoughSurface surface)
        : fresnel_(std::move(fresnel)), surface_(std::move(surface)) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;

  private:
    PreparedFresnel fresnel_;
    RoughSurface surface_;
};

}  // namespace lxs::shading
