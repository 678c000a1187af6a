// The coating of "glossy" and "glossytranslucent", from its textures.
#pragma once

#include <string>

#include "bsdfs/glossy_bsdf.h"
#include "prepared_texture.h"
#include "rough_surface.h"

namespace lxs::shading {

class CoatingParameters {
  public:
    /// Reads Ks, Ka, d, index and the roughness, each name after `prefix`, and "multibounce".
    CoatingParameters(const ParameterReader& reader, const AssetContext& assets,
                      const std::string& prefix, const Rgb& default_ks, bool multibounce);

    Coating at(const TexturePoint& point) const;
    MicrofacetLobe facets(const ShadingPoint& point) const { return surface_.at(point); }
    bool reads_image() const;

  private:
    PreparedColor ks_, ka_;
    PreparedFloat index_, depth_;
    RoughSurface surface_;
    bool multibounce_;
};

}  // namespace lxs::shading
