// A diffuse base and a coating that shade off into each other and lose some light: LuxRender's
// "glossy_lossy".
// Source: Ashikhmin & Shirley 2000, "An Anisotropic Phong BRDF Model", equations 4 and 5, with
// Schlick's facets in the place of Phong's.
#pragma once

#include "glossy_bsdf.h"

namespace lxs::shading {

/// f = 28 Kd / (23 pi) (1 - Ks) (1 - (1 - cos_i / 2)^5) (1 - (1 - cos_o / 2)^5)
///   + D(h) F(cos_h) / (4 cos_h max(cos_i, cos_o)).
class FresnelBlendBsdf final : public Bsdf {
  public:
    /// Of `coating`, reflectance and optical depth count.
    FresnelBlendBsdf(const Rgb& kd, const Coating& coating, const MicrofacetLobe& facets);

    LobeMask lobes() const override { return kDiffuse | kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    Rgb base(float cos_o, float cos_i) const;
    Rgb coat(const HalfVector& half) const;
    float p_coat(LobeMask mask) const;

    Rgb kd_;
    Coating coating_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
