// Polished metal: a rough and a mirror-like reflection added up.
#pragma once

#include "fresnel.h"
#include "lxs/sdk/bsdf.h"
#include "microfacet_albedo.h"
#include "microfacet_lobe.h"
#include "thin_film.h"

namespace lxs::shading {

class ShinyMetalBsdf final : public Bsdf {
  public:
    /// `rough` and `smooth`: indices of the two reflections; `film` lies on the smooth one.
    ShinyMetalBsdf(const FresnelValue& rough, const FresnelValue& smooth, const ThinFilm& film,
                   const MicrofacetLobe& facets)
        : rough_(rough), smooth_(smooth), film_(film), facets_(facets) {}

    LobeMask lobes() const override { return kGlossy | kSpecular; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    float p_rough(const Vec3& wo, LobeMask mask) const;
    /// What the mirror-like part reflects: never more than the rough part leaves over, or the two
    /// together would send back more light than arrives.
    Rgb smooth_reflectance(const Vec3& wo) const;
    Rgb rough_albedo(float cosine) const;

    FresnelValue rough_, smooth_;
    ThinFilm film_;
    MicrofacetLobe facets_;
};

}  // namespace lxs::shading
