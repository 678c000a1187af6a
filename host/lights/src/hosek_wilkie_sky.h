// Radiance of the clear sky (Hosek & Wilkie 2012, "An analytic model for full spectral sky-dome
// radiance").
#pragma once

#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Sky around +z over black ground, evaluated by wavelengths and tabulated as colours over the two
/// angles that it depends on.
class HosekWilkieSky {
  public:
    static constexpr double kLeastTurbidity = 1, kMostTurbidity = 10;

    /// `sun` is the direction to the sun, at or above the horizon (below it: the horizon's sky), of
    /// which LuxRender takes the length along into all angles (1: the model as published);
    /// `turbidity` within the bounds above.
    HosekWilkieSky(const Vec3& sun, double turbidity);
    /// Colour of the unit direction `w`, its luminance in cd m^-2; finite, >= 0. Below the horizon
    /// the horizon's value at the same angle from the sun.
    Rgb radiance(const Vec3& w) const;

  private:
    const Rgb& entry(std::size_t height, std::size_t angle) const {
        return table_[angle * kHeights + height];
    }

    // Fine towards the horizon and towards the sun, where the model is steep.
    static constexpr std::size_t kHeights = 64, kAngles = 128;
    Vec3 sun_;
    std::vector<Rgb> table_;
};

}  // namespace lxs
