// Translucent sheet under rough coatings: LuxRender's "glossytranslucent".
#pragma once

#include "glossy_bsdf.h"

namespace lxs::shading {

/// A coated base on either side, and a diffuse transmission that both coatings weaken:
///   f = Kt (1 - Kd) sqrt((1 - S_o(u)) (1 - S_i(u))) / pi,
/// S being Schlick's Fresnel term of each side's coating and u the cosine of half the angle between
/// wo and the mirror image of wi. With equal coatings this is Kt (1 - Kd) (1 - S(u)) / pi, which is
/// what LuxRender's image of lux-conformance's material-glossytranslucent (Kd 0.3, Ks 0.05) shows:
/// the light that comes through its sphere is within 1.4 % of it in each channel; without 1 - Kd,
/// or with the term once for each coating, it is off by 65 % or 10 %. Different coatings, which
/// that image doesn't have, are assumed to share the term.
class GlossyTranslucentBsdf final : public Bsdf {
  public:
    /// `front` and `back`: what reflects light that comes from the side of the normal and from the
    /// other one. `kt`: transmittance of the base.
    GlossyTranslucentBsdf(const GlossyBsdf& front, const GlossyBsdf& back, const Rgb& kt,
                          const Vec3& ng, const Vec3& ns)
        : sides_{front, back}, kd_(front.kd()), kt_(kt), ng_(ng), ns_(ns), opaque_(is_black(kt)) {}

    LobeMask lobes() const override {
        const LobeMask reflected = sides_[0].lobes() | sides_[1].lobes();
        return opaque_ ? reflected : LobeMask(reflected | kDiffuse);
    }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    const GlossyBsdf& side_of(const Vec3& w) const { return sides_[w.dot(ng_) < 0 ? 1 : 0]; }
    bool transmits(LobeMask mask) const { return (mask & kDiffuse) && !opaque_; }
    /// Probability of sampling the transmission.
    float p_transmit(const Vec3& wo, LobeMask mask) const;
    Rgb transmission(const Vec3& wo, const Vec3& wi) const;
    Rgb transmitted_albedo(const Vec3& wo) const;

    GlossyBsdf sides_[2];
    Rgb kd_, kt_;
    Vec3 ng_, ns_;
    bool opaque_;
};

}  // namespace lxs::shading
