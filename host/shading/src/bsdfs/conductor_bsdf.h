// Rough metal.
#pragma once

#include "fresnel.h"
#include "lxs/sdk/bsdf.h"
#include "microfacet_lobe.h"

namespace lxs::shading {

class ConductorBsdf final : public Bsdf {
  public:
    ConductorBsdf(const FresnelValue& fresnel, const MicrofacetLobe& facets)
        : fresnel_(fresnel), facets_(facets) {}

    LobeMask lobes() const override { return kGlossy; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    FresnelValue fresnel_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
