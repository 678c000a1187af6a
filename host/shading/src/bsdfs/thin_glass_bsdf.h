// Architectural glass: reflects on its front side, lets light through undeviated.
#pragma once

#include "specular_bsdf.h"
#include "thin_film.h"

namespace lxs::shading {

/// Share of light that architectural glass lets through under the cosine `cos_o` (either sign);
/// the angle is the one in the medium of lower index on both sides, since nothing bends.
/// LuxRender's images show the same: (1 - F) at each crossing, no reflection from behind. A whole
/// `pane` has two faces, between which light goes to and fro: (1 - F) / (1 + F).
Rgb thin_glass_transmission(const Rgb& kt, float eta, float cos_o, bool pane = false);

class ThinGlassBsdf final : public SpecularBsdf {
  public:
    /// `eta`: index behind the surface (-ng) / index before it (+ng).
    ThinGlassBsdf(const Rgb& kr, const Rgb& kt, float eta, bool pane, const ThinFilm& film,
                  const Vec3& ng, const Vec3& ns)
        : kr_(kr), kt_(kt), eta_(eta), pane_(pane), film_(film), ng_(ng), ns_(ns) {}

    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    float first_specular(const Vec3& wo) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    Rgb reflection(const Vec3& wo) const;

    Rgb kr_, kt_;
    float eta_;
    bool pane_;
    ThinFilm film_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
