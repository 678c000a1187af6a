// Ideal mirror.
#pragma once

#include "specular_bsdf.h"
#include "thin_film.h"

namespace lxs::shading {

class MirrorBsdf final : public SpecularBsdf {
  public:
    MirrorBsdf(const Rgb& reflectance, const ThinFilm& film, const Vec3& ng, const Vec3& ns)
        : reflectance_(reflectance), film_(film), ng_(ng), ns_(ns) {}

    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override {
        return mask & kSpecular ? reflectance_ * film_.filter(wo.dot(ns_)) : Rgb(0.0f);
    }

  private:
    Rgb reflectance_;
    ThinFilm film_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
