// Diffuse reflection and diffuse transmission: LuxRender's "mattetranslucent".
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"
#include "oren_nayar_shape.h"

namespace lxs::shading {

/// f = Kr / pi on wo's side of the surface and Kt / pi on the other, both times the shape that a
/// rough surface has.
class TranslucentBsdf final : public Bsdf {
  public:
    /// `sigma`: standard deviation of the facets' slope angle, radians, >= 0.
    TranslucentBsdf(const Rgb& kr, const Rgb& kt, float sigma, const Vec3& ng, const Vec3& ns)
        : kr_(kr), kt_(kt), shape_(sigma), ng_(ng), ns_(ns) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3& wo, const Vec3& wi, Transport transport, LobeMask mask) const override;
    float pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const override;
    bool sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(const Vec3& wo, LobeMask mask) const override;

  private:
    float p_reflect() const {
        const float reflected = max_component(kr_), transmitted = max_component(kt_);
        return reflected > 0 ? reflected / (reflected + transmitted) : 0.0f;
    }

    Rgb kr_, kt_;
    OrenNayarShape shape_;
    Vec3 ng_, ns_;
};

}  // namespace lxs::shading
