// A Bsdf about a normal that a bump map has tilted.
#pragma once

#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// Adds two things to a Bsdf that takes its cosines to a tilted normal n.
///
/// Sides: light that arrives from one side of the tilted surface isn't reflected to the other.
/// LuxRender's images show it: on the conformance scene texture-bump a ball that reflects
/// |cos(wi, n)| whatever the side is 4 % too bright, and 10 % at its outline; with this rule most
/// blocks agree within 2 %, the brightest, which direct light dominates, are 4 to 6 % too dark.
///
/// Cosines: a part of a mix with a bump map of its own meets integrators that take them to another
/// normal ns. Radiance scatters by f |cos(wi, n)|, so that the value becomes
/// f |cos(wi, n)| / |cos(wi, ns)|; its adjoint (Veach 1997, section 5.3) has wo in the place of
/// wi, as the integrators' shading-normal factor has.
class TiltedBsdf final : public Bsdf {
  public:
    /// `part` takes its cosines to `tilted`; `ns` is the normal that integrators see.
    TiltedBsdf(const Bsdf& part, const Vec3& tilted, const Vec3& ng, const Vec3& ns)
        : part_(part), tilted_(tilted), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return part_.lobes(); }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    float first_specular(const Vec3& wo) const override { return part_.first_specular(wo); }
    Rgb albedo(const Vec3& wo, LobeMask mask) const override { return part_.albedo(wo, mask); }

  private:
    /// Whether light gets from wi to wo at all.
    bool joins(const Vec3& wo, const Vec3& wi) const;
    /// |cos(w, tilted)| / |cos(w, ns)|.
    float cosine_ratio(const Vec3& w) const;

    const Bsdf& part_;
    Vec3 tilted_, ng_, ns_;
};

}  // namespace lxs::shading
