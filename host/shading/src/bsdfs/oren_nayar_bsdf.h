// Rough diffuse reflection.
// Source: Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", qualitative model.
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

class OrenNayarBsdf final : public Bsdf {
  public:
    /// `sigma`: standard deviation of the facets' slope angle, radians, >= 0.
    OrenNayarBsdf(const Rgb& kd, float sigma, const Vec3& ng, const Vec3& ns);

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// f * pi / Kd.
    float shape(const Vec3& wo, const Vec3& wi) const;

    Rgb kd_;
    float a_, b_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
