// Radiance of the clear sky (Preetham, Shirley & Smits 1999, "A practical analytic model for
// daylight").
#pragma once

#include <array>

#include "lxs/sdk/types.h"

namespace lxs {

/// Sky around +z.
class SkyModel {
  public:
    /// Below it the published coefficients run into a pole of the zenith luminance.
    static constexpr double kLeastTurbidity = 1.9;

    /// `sun` is the direction to the sun, of which LuxRender takes the length along into angles
    /// from the sun (1: the model as published), though not into the sun's height; `turbidity` from
    /// kLeastTurbidity; `factors` multiply the coefficients A to E of luminance and chromaticities
    /// (1: the model as published).
    SkyModel(const Vec3& sun, double turbidity, const std::array<double, 5>& factors);
    /// Colour of the unit direction `w`, its luminance in cd m^-2; finite, >= 0. Below the horizon
    /// the horizon's value at the same angle from the sun.
    Rgb radiance(const Vec3& w) const;

  private:
    /// Perez distribution: coefficients A to E, and the zenith's value over the distribution there.
    struct Perez {
        std::array<float, 5> c{};
        float scale = 0;
    };
    static Perez make(const std::array<double, 5>& c, double zenith, double sun_angle);
    static float evaluate(const Perez& perez, float cos_theta, float gamma, float cos_gamma);

    Vec3 sun_;
    Perez luminance_, x_, y_;  ///< cd m^-2; chromaticities
};

}  // namespace lxs
