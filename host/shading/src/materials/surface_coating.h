// The rough coating of "glossy" and its relatives: parameters.
#pragma once

#include <string>

#include "bsdfs/glossy_bsdf.h"
#include "prepared_texture.h"
#include "rough_surface.h"

namespace lxs::shading {

class SurfaceCoating {
  public:
    /// Reads Ks, Ka, d, index, the roughness and "multibounce", each name after `prefix`.
    SurfaceCoating(const ParameterReader& reader, const AssetContext& assets,
                   const std::string& prefix = "", const Rgb& default_ks = Rgb(1.0f),
                   float default_roughness = 0.1f);

    Coating coating_at(const TexturePoint& point) const;
    MicrofacetLobe facets_at(const ShadingPoint& point) const { return surface_.at(point); }
    /// Adds what is true of a material by these textures.
    void add_to(MaterialFacts& facts) const;

  private:
    PreparedColor ks_, ka_;
    PreparedFloat index_, depth_;
    RoughSurface surface_;
    bool multibounce_;
};

/// Declaration of the colour under a coating.
inline ParameterDeclaration coated_base_parameter() {
    return {"Kd", ParameterType::ColorTexture, "1 1 1", "diffuse reflectance of the base, 0 to 1"};
}

/// Declarations of what SurfaceCoating reads.
std::vector<ParameterDeclaration> coating_parameters();

}  // namespace lxs::shading
