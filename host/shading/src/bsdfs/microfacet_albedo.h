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
    /// Likewise of `grazing`.
    float average_grazing(float roughness) const;

  private:
    static constexpr int kSize = 24;

    MicrofacetAlbedo();

    std::array<std::array<Entry, kSize>, kSize> entries_;  ///< by roughness, then cosine
    std::array<float, kSize> averages_, grazing_averages_;
};

/// The part that grazing angles add where facets are of a dielectric, by the exact Fresnel term: F
/// is r0 + (1 - r0) rise, and the albedo that of `rise`.
class DielectricRise {
  public:
    static const DielectricRise& table();

    /// `r0`: reflectance at normal incidence, below 1.
    static float rise(float cosine, float r0);
    /// Albedo of facets that reflect `rise`.
    float at(float c, float roughness, float r0) const;
    /// Its cosine-weighted mean over the hemisphere.
    float average(float roughness, float r0) const;
    /// That of `rise` itself.
    float mean(float r0) const;

  private:
    static constexpr int kSize = 24, kSteps = 8;  ///< of reflectances
    using Steps = std::array<float, kSteps>;

    DielectricRise();

    std::array<std::array<Steps, kSize>, kSize> entries_;  ///< by roughness, then cosine
    std::array<Steps, kSize> averages_;
    Steps means_;
};

}  // namespace lxs::shading
