// One Bsdf for each side of a surface.
#pragma once

#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// The side that the eye is on decides: `front` scatters what leaves on the side of the geometric
/// normal, `back` what leaves on the other one. For power, whose wo is where light comes from, a
/// reflection hence belongs to wo's side and a transmission to the other.
class DoubleSideBsdf final : public Bsdf {
  public:
    /// Either may be null (scatters nothing). `transmits`: one of them may let light through.
    DoubleSideBsdf(const Bsdf* front, const Bsdf* back, bool transmits, const Vec3& ng,
                   const Vec3& ns)
        : sides_{front, back}, transmits_(transmits), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override;
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    /// The Bsdf of w's side, or null if it has none of `mask`.
    const Bsdf* side_of(const Vec3& w, LobeMask mask) const;
    const Bsdf* other_side(const Vec3& w, LobeMask mask) const { return side_of(-w, mask); }
    /// Probability of sampling the Bsdf of wo's side. The other one takes part only for the sake of
    /// transmitted power; densities don't depend on what is carried, so it does for radiance too.
    float p_own(const Vec3& wo, LobeMask mask) const;

    const Bsdf* sides_[2];
    bool transmits_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
