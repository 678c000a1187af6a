// A surface that isn't there: everything passes straight through.
#pragma once

#include "specular_bsdf.h"

namespace lxs::shading {

class NullBsdf final : public SpecularBsdf {
  public:
    bool sample(const Vec3& wo, const Vec2&, float, Transport, LobeMask mask,
                BsdfSample& sample) const override {
        if (!(mask & kSpecular)) return false;
        sample = {-wo, Rgb(1.0f), 0, kSpecular, true, true};
        return true;
    }
    Rgb albedo(const Vec3&, LobeMask mask) const override {
        return Rgb(mask & kSpecular ? 1.0f : 0.0f);
    }
};

}  // namespace lxs::shading
