// Ideal diffuse reflection.
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// f = Kd / pi on both shading sides.
class LambertBsdf final : public Bsdf {
  public:
    LambertBsdf(const Rgb& kd, const Vec3& ng, const Vec3& ns) : kd_(kd), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport, LobeMask mask) const override {
        return (mask & kDiffuse) && same_side(wo, wi, ng_) ? kd_ * kInvPi : Rgb(0.0f);
    }
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override {
        if (!(mask & kDiffuse) || !same_side(wo, wi, ng_)) return 0;
        return std::abs(wi.dot(ns_)) * kInvPi;
    }
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3&, LobeMask mask) const override {
        return mask & kDiffuse ? kd_ : Rgb(0.0f);
    }
    bool lambertian(Rgb& kd) const override {
        kd = kd_;
        return true;
    }

  private:
    Rgb kd_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
