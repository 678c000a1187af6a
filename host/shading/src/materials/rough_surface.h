// The microfacets of rough materials, from u and v roughness textures.
#pragma once

#include <string>

#include "bsdfs/microfacet_lobe.h"
#include "lxs/scene/material.h"
#include "prepared_texture.h"

namespace lxs::shading {

class RoughSurface {
  public:
    enum class Facets : std::uint8_t {
        Schlick,  ///< LuxRender's
        Smith     ///< of Trowbridge and Reitz, with Smith's shadowing
    };

    /// Reads "uroughness" and "vroughness" after `prefix`.
    RoughSurface(const ParameterReader& reader, const AssetContext& assets, float fallback = 0.1f,
                 const std::string& prefix = "", Facets facets = Facets::Schlick);

    MicrofacetLobe at(const ShadingPoint& point) const {
        const float u = u_.at(point.texture), v = v_.at(point.texture);
        const Frame frame(point.ns, point.dpdu);
        if (facets_ == Facets::Smith) return {TrowbridgeReitz(u, v), frame, point.ng};
        return {SchlickDistribution(u, v), frame, point.ng};
    }
    /// Between these lies the root of the product of both roughnesses, within their limits.
    float least_alpha() const { return varies() ? 0.0f : constant_alpha(); }
    float most_alpha() const { return varies() ? 1.0f : constant_alpha(); }
    bool reads_image() const { return u_.reads_image() || v_.reads_image(); }

  private:
    bool varies() const { return u_.varies() || v_.varies(); }
    float constant_alpha() const;

    PreparedFloat u_, v_;
    Facets facets_;
};

}  // namespace lxs::shading
