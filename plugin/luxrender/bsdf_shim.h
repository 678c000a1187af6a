// LuxRender's material at one point as the engine sees it.
#pragma once

#include "aips/adapter/bsdf.h"
#include "lux_view.h"

namespace aips::luxrender {

/// `surface` is what LuxView::intersect kept.
class BsdfShim final : public Bsdf {
  public:
    BsdfShim(const LuxView& view, const void* surface) : view_(view), surface_(surface) {}
    LobeMask lobes() const override { return static_cast<LobeMask>(view_.lobes(surface_)); }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override;
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override;
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& sample) const override;
    Rgb albedo(Vec3 wo, LobeMask mask) const override;

  private:
    const LuxView& view_;
    const void* surface_;
};

}  // namespace aips::luxrender
