// Participating media between surfaces.
#pragma once

#include "lxs/sdk/index_curve.h"
#include "lxs/sdk/types.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

/// Clear, absorbing medium (LuxRender volume "clear"): Beer-Lambert attenuation.
class Medium {
  public:
    /// `absorption` per unit of distance; `index` of refraction for glass2.
    Medium(const Rgb& absorption, const IndexCurve& index)
        : absorption_(absorption), index_(index) {}
    Medium(const Rgb& absorption, float index) : Medium(absorption, IndexCurve{index}) {}
    /// Share that is left after `distance`; at `wavelengths`, or of R, G and B if that is null.
    Rgb transmittance(float distance, const Wavelengths* wavelengths = nullptr) const;
    const IndexCurve& index_curve() const { return index_; }
    /// Index for all wavelengths where light is not dispersed.
    float index() const { return index_.at(kMiddleNm); }
    bool absorbs() const { return !is_black(absorption_); }

  private:
    Rgb absorption_;
    IndexCurve index_;
};

}  // namespace lxs
