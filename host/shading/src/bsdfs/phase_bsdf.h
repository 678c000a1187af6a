// A surface that scatters like a particle: LuxRender's "scatter".
// Source: Blasi, Le Saec & Schlick 1993, "A Rendering Algorithm for Discrete Volume Density
// Objects" (phase function).
#pragma once

#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// f |cos_i| = Kd p(wo, wi) over the whole sphere, p being Schlick's phase function; the surface's
/// orientation plays no part except that f is per projected solid angle.
class PhaseBsdf final : public Bsdf {
  public:
    /// `g` in (-1, 1): mean cosine of the deflection, per channel; 0 scatters evenly.
    PhaseBsdf(const Rgb& kd, const Rgb& g, const Vec3& ng, const Vec3& ns)
        : kd_(kd), g_(g), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3&, LobeMask mask) const override {
        return mask & kDiffuse ? kd_ : Rgb(0.0f);
    }

  private:
    Rgb kd_, g_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
