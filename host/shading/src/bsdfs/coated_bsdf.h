// Any Bsdf under a rough coating: what "glossy" is with a diffuse base.
// Sources: those of GlossyBsdf.
#pragma once

#include "glossy_bsdf.h"

namespace lxs::shading {

/// Coating's reflection on the front plus what it leaves of the base there. Over a Lambertian base
/// this is GlossyBsdf with a bare back. Light that goes through the base is dimmed as LuxRender
/// dims it: by the root of what the coating lets in at the half angle of one direction and the
/// other's mirror image, and by its absorption along both.
class CoatedBsdf final : public Bsdf {
  public:
    /// `base` null: scatters nothing.
    CoatedBsdf(const Bsdf* base, const Coating& coating, const MicrofacetLobe& facets)
        : base_(base),
          coating_(coating),
          coat_(Rgb(0.0f), coating, facets, CoatedBack::Bare),
          ng_(facets.ng()),
          ns_(facets.ns()) {}

    LobeMask lobes() const override { return kGlossy | (base_ ? base_->lobes() : LobeMask(0)); }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    bool base_takes_part(LobeMask mask) const { return base_ && (base_->lobes() & mask); }
    float p_coat(const Vec3& wo, LobeMask mask) const;
    /// Share of the base's scattering that gets out.
    Rgb passed(const Vec3& wo, const Vec3& wi) const;
    /// Share of light along `w` that a single crossing of the front leaves.
    Rgb crossing(const Vec3& w) const;

    const Bsdf* base_;
    Coating coating_;
    GlossyBsdf coat_;  ///< over a black base
    Vec3 ng_, ns_;
};

/// What a coating lets straight through along a direction under the cosine `c`.
Rgb coating_transmission(const Coating& coating, float c);

}  // namespace lxs::shading
