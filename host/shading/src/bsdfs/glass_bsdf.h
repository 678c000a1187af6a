// Smooth dielectric interface: reflection and refraction.
#pragma once

#include "specular_bsdf.h"
#include "thin_film.h"

namespace lxs::shading {

class GlassBsdf final : public SpecularBsdf {
  public:
    /// `eta`: index behind the surface (-ng) / index before it (+ng).
    GlassBsdf(const Rgb& kr, const Rgb& kt, float eta, const ThinFilm& film, const Vec3& ng,
              const Vec3& ns)
        : kr_(kr), kt_(kt), eta_(eta), film_(film), ng_(ng), ns_(ns) {}

    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    float first_specular(const Vec3& wo) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// What a ray that comes from `wo` meets.
    struct Meeting {
        Vec3 n;         ///< shading normal, on the side of wo
        float eta = 1;  ///< index behind over index before
        Rgb reflected{0.0f}, transmitted{0.0f};
        float p_reflect = 0;  ///< with which `sample` reflects
    };
    /// False if nothing is scattered.
    bool meet(const Vec3& wo, Meeting& met) const;

    Rgb kr_, kt_;
    float eta_;
    ThinFilm film_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
