// What all Bsdfs share that consist of Dirac deltas only.
#pragma once

#include "directions.h"
#include "lxs/sdk/bsdf.h"

namespace lxs::shading {

/// Probability of the first of two lobes, in proportion to what they weigh (>= 0); 0 if that is
/// nothing for both.
inline float share_of_first(float first, float second) {
    const float total = first + second;
    return total > 0 ? first / total : 0;
}

/// A Bsdf that `evaluate` and `pdf` never see.
class SpecularBsdf : public Bsdf {
  public:
    LobeMask lobes() const final { return kSpecular; }
    Rgb evaluate(const Vec3&, const Vec3&, Transport, LobeMask) const final { return Rgb(0.0f); }
    float pdf(const Vec3&, const Vec3&, LobeMask) const final { return 0; }

  protected:
    ~SpecularBsdf() = default;
};

}  // namespace lxs::shading
