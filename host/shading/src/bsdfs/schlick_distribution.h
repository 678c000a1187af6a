// Microfacet distribution of Schlick 1994, "An Inexpensive BRDF Model for Physically-based
// Rendering", section 4, which LuxRender's metals and glossy coatings use.
#pragma once

#include "directions.h"

namespace lxs::shading {

/// Distribution of facet normals h around local +z. D(h) = Z(h) A(h) / pi with
///   Z = r / (1 - (1 - r) cos^2)^2 and A = p^2 / (p^2 + (1 - p^2) t^2)^(3/2),
/// where t in [0, 1] is the angle between h's projection and the direction of the larger roughness,
/// over a right angle. r = uroughness * vroughness and p = (smaller / larger roughness)^2.
/// Schlick's own A is sqrt(p / (p^2 + (1 - p^2) w^2)), w a cosine; the one here is the density of
/// the azimuths that his and LuxRender's way to draw facets gives. LuxRender weighs such facets as
/// if they had his A, so that what it renders has the A here wherever it finds light by following
/// reflected rays, which for grained surfaces is almost everywhere
/// (docs/measured/conformance.md). Both are 1 where p is. This one's mean over the azimuths
/// is 1, so that no light is lost.
class SchlickDistribution {
  public:
    /// Below it LuxRender's roughness makes no visible difference, but numbers would overflow.
    static constexpr float kMinRoughness = 6e-3f;

    /// Roughness along local x and y; LuxRender's parameters, limited to [kMinRoughness, 1].
    SchlickDistribution(float u_roughness, float v_roughness);

    float roughness() const { return roughness_; }
    bool grained() const { return isotropy_ < 1; }
    /// D(h) for h.z > 0; integrates with h.z to 1.
    float density(const Vec3& h) const {
        return zenith(h) * kInvPi * (isotropy_ < 1 ? azimuth(h) : 1.0f);
    }
    /// Draws h with density D(h) * h.z per steradian.
    Vec3 sample(const Vec2& u) const;
    /// Schlick's shadowing of one direction over its cosine: G1(c) / c = 1 / (c (1 - r) + r).
    float shadowing_over_cosine(float c) const { return 1 / (c * (1 - roughness_) + roughness_); }
    /// Upper bound of what facets that reflect everything would send back under G1 alone: above 1
    /// at grazing angles, where Schlick's shadowing is too weak. The facets' projected area times
    /// G1(c) / c.
    float reflected_bound(float c) const { return projected_area(c) * shadowing_over_cosine(c); }

  private:
    float zenith(const Vec3& h) const {
        const float d = h.x * h.x + h.y * h.y + roughness_ * h.z * h.z;
        return roughness_ / (d * d);
    }
    float azimuth(const Vec3& h) const;
    /// At most so much area do the facets turn towards a direction of cosine `c`, per area of the
    /// surface.
    float projected_area(float c) const;
    Vec2 sample_azimuth(float u) const;

    float roughness_;
    float isotropy_;      ///< p in (0, 1]; 1 means isotropic
    bool grain_along_y_;  ///< else along x: the direction with the smaller roughness
};

}  // namespace lxs::shading
