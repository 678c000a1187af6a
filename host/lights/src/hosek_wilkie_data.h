// Coefficients of the Hosek-Wilkie sky, CIE XYZ.
#pragma once

#include <array>

namespace lxs {

/// One colour channel's data, indexed by the ground's albedo (0 or 1), turbidity - 1 and control
/// point of the quintic Bezier curve over the sun's elevation.
struct HosekWilkieChannel {
    static constexpr int kTurbidities = 10, kControlPoints = 6, kCoefficients = 9;
    template <typename T>
    using Table = std::array<std::array<std::array<T, kControlPoints>, kTurbidities>, 2>;
    /// Of the distribution, in the order A B C D E F G I H of the paper's equation 8.
    Table<std::array<float, kCoefficients>> coefficients;
    /// Mean radiance, colour-matched W m^-2 sr^-1: times 683 lm/W, Y is the luminance in cd m^-2.
    Table<float> radiance;
};

/// Channels X, Y and Z.
using HosekWilkieData = std::array<HosekWilkieChannel, 3>;
extern const HosekWilkieData kHosekWilkieData;

}  // namespace lxs
