// Share of light that a whole MicrofacetLobe sends back, tabulated.
#pragma once

#include <array>

namespace lxs::shading {

/// Directional albedo of isotropic facets of Schlick roughness r, split by Schlick's Fresnel term
/// r0 + (1 - r0) (1 - u)^5, so that the albedo for any r0 is r0 * constant + (1 - r0) * grazing
/// (Karis 2013, "Real Shading in Unreal Engine 4", split-sum tables).
class MicrofacetAlbedo {
  public:
    struct Entry {
        float constant = 0;  ///< albedo of facets that reflect everything
        float grazing = 0;   ///< albedo of facets that reflect (1 - cos)^5
    };

    /// The table, made on first use by a fixed quadrature; some milliseconds.
    static const MicrofacetAlbedo& table();

    /// Albedo seen under the cosine `c` in [0, 1]; roughness r as SchlickDistribution has it.
    Entry at(float c, float roughness) const;
    /// Cosine-weighted mean of `constant` over the hemisphere.
    float average(float roughness) const;

  private:
    static constexpr int kSize = 24;

    MicrofacetAlbedo();

    std::array<std::array<Entry, kSize>, kSize> entries_;  ///< by roughness, then cosine
    std::array<float, kSize> averages_;
};

}  // namespace lxs::shading
