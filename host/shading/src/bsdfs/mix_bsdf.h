// Weighted sum of two Bsdfs.
#pragma once

#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

class MixBsdf final : public Bsdf {
  public:
    /// Either child may be null (scatters nothing). `amount` in [0, 1] is the second one's share.
    MixBsdf(const Bsdf* first, const Bsdf* second, float amount, const Vec3& ns)
        : children_{first, second}, weights_{1 - amount, amount}, ns_(ns) {}

    LobeMask lobes() const override;
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;
    bool lambertian(Rgb& kd) const override;

  private:
    bool takes_part(int child, LobeMask mask) const;
    /// Probability of sampling the second child among those that have a lobe in `mask`.
    float p_second(LobeMask mask) const;

    const Bsdf* children_[2];
    float weights_[2];
    Vec3 ns_;
};

}  // namespace lxs::shading
