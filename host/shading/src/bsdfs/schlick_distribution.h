// Microfacet distribution of Schlick 1994, "An Inexpensive BRDF Model for Physically-based
// Rendering", section 4, which LuxRender's metals and glossy coatings use.
#pragma once

#include "directions.h"

namespace lxs::shading {

/// Distribution of facet normals h around local +z. D(h) = Z(h) A(h) / pi with
///   Z = r / (1 - (1 - r) cos^2)^2 and A = sqrt(p / (p^2 + (1 - p^2) w^2)),
/// where w is the cosine between the grain and h's projection. r = uroughness * vroughness and
/// p = (smaller / larger roughness)^2.
class SchlickDistribution {
  public:
    /// Roughness along local x and y; LuxRender's parameters, limited to [0.006, 1].
    SchlickDistribution(float u_roughness, float v_roughness);

    float roughness() const { return roughness_; }
    /// D(h) for h.z > 0; integrates with h.z to 1 (A's mean is at most 1: a grain loses some).
    float density(const Vec3& h) const {
        return zenith(h) * kInvPi * (isotropy_ < 1 ? azimuth(h) : 1.0f);
    }
    /// Density times 1 / h.z with which `sample` draws h; at least D(h).
    float sampling_density(const Vec3& h) const {
        if (isotropy_ >= 1) return zenith(h) * kInvPi;
        const float a = azimuth(h);
        return zenith(h) * kInvPi * 0.5f * (1 + a * a);
    }
    /// Draws h with density sampling_density(h) * h.z per steradian.
    Vec3 sample(const Vec2& u) const;
    /// Schlick's shadowing of one direction over its cosine: G1(c) / c = 1 / (c (1 - r) + r).
    float shadowing_over_cosine(float c) const { return 1 / (c * (1 - roughness_) + roughness_); }
    /// Upper bound of what facets that reflect everything would send back under G1 alone: above 1
    /// at grazing angles, where Schlick's shadowing is too weak. The facets' projected area,
    /// (c + sqrt(a^2 + (1 - a^2) c^2)) / 2 (Walter et al. 2007, equation 34), times G1(c) / c; a is
    /// the larger roughness.
    float reflected_bound(float c) const {
        const float area = 0.5f * (c + std::sqrt(widest_ + (1 - widest_) * c * c));
        return area * shadowing_over_cosine(c);
    }

  private:
    float zenith(const Vec3& h) const {
        const float d = h.x * h.x + h.y * h.y + roughness_ * h.z * h.z;
        return roughness_ / (d * d);
    }
    float azimuth(const Vec3& h) const;
    Vec2 sample_azimuth(float u) const;

    float roughness_;
    float widest_;        ///< square of the larger roughness
    float isotropy_;      ///< p in (0, 1]; 1 means isotropic
    bool grain_along_y_;  ///< else along x: the direction with the smaller roughness
};

}  // namespace lxs::shading
