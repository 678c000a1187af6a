// Ideal mirror, or smooth metal.
#pragma once

#include <optional>

#include "fresnel.h"
#include "specular_bsdf.h"
#include "thin_film.h"

namespace lxs::shading {

class MirrorBsdf final : public SpecularBsdf {
  public:
    /// `metal`: what the reflectance is a factor on; none: it is all that there is.
    MirrorBsdf(const Rgb& reflectance, const std::optional<FresnelValue>& metal,
               const ThinFilm& film, const Vec3& ng, const Vec3& ns)
        : reflectance_(reflectance), metal_(metal), film_(film), ng_(ng), ns_(ns) {}

    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override {
        return mask & kSpecular ? reflected(wo) : Rgb(0.0f);
    }

  private:
    Rgb reflected(const Vec3& wo) const {
        const float cosine = wo.dot(ns_);
        const Rgb share = reflectance_ * film_.filter(cosine);
        return metal_ ? share * fresnel_conductor(std::min(std::abs(cosine), 1.0f), *metal_)
                      : share;
    }

    Rgb reflectance_;
    std::optional<FresnelValue> metal_;
    ThinFilm film_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
