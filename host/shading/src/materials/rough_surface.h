// The microfacets of rough materials, from u and v roughness textures.
#pragma once

#include <string>

#include "bsdfs/microfacet_lobe.h"
#include "lxs/scene/material.h"
#include "prepared_texture.h"

namespace lxs::shading {

class RoughSurface {
  public:
    /// Reads "uroughness" and "vroughness" after `prefix`.
    RoughSurface(const ParameterReader& reader, const AssetContext& assets, float fallback = 0.1f,
                 const std::string& prefix = "");

    MicrofacetLobe at(const ShadingPoint& point) const {
        const SchlickDistribution distribution(u_.at(point.texture), v_.at(point.texture));
        return {distribution, Frame(point.ns, point.dpdu), point.ng};
    }
    bool reads_image() const { return u_.reads_image() || v_.reads_image(); }

  private:
    PreparedFloat u_, v_;
};

}  // namespace lxs::shading
