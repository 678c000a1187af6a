// Rough diffuse reflection.
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"
#include "oren_nayar_shape.h"

namespace lxs::shading {

class OrenNayarBsdf final : public Bsdf {
  public:
    /// `sigma`: standard deviation of the facets' slope angle, radians, >= 0.
    OrenNayarBsdf(const Rgb& kd, float sigma, const Vec3& ng, const Vec3& ns)
        : kd_(kd), shape_(sigma), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    Rgb kd_;
    OrenNayarShape shape_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
