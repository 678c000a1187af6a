// Radiance of the clear sky (Hosek & Wilkie 2012, "An analytic model for full spectral sky-dome
// radiance").
#pragma once

#include <array>

#include "hosek_wilkie_data.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// Sky around +z over black ground.
class HosekWilkieSky {
  public:
    static constexpr double kLeastTurbidity = 1, kMostTurbidity = 10;

    /// `sun` is the unit direction to the sun, at or above the horizon (below it: the horizon's
    /// sky); `turbidity` within the bounds above.
    HosekWilkieSky(const Vec3& sun, double turbidity);
    /// Colour of the unit direction `w`, its luminance in cd m^-2; finite, >= 0. Below the horizon
    /// the horizon's value at the same angle from the sun.
    Rgb radiance(const Vec3& w) const;

  private:
    struct Channel {
        std::array<float, HosekWilkieChannel::kCoefficients> c{};
        float mean = 0;  ///< radiance, cd m^-2
    };
    static float distribution(const Channel& channel, float cos_theta, float gamma,
                              float cos_gamma);

    Vec3 sun_;
    std::array<Channel, 3> xyz_;
};

}  // namespace lxs
