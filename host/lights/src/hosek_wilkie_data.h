// Coefficients of the Hosek-Wilkie sky by wavelength, over black ground.
#pragma once

#include <array>

namespace lxs {

/// One wavelength's data, indexed by turbidity - 1 and control point of the quintic Bezier curve
/// over the sun's elevation.
struct HosekWilkieBand {
    static constexpr int kTurbidities = 10, kControlPoints = 6, kCoefficients = 9;
    template <typename T>
    using Table = std::array<std::array<T, kControlPoints>, kTurbidities>;
    /// Of the distribution, in the order A B C D E F G I H of the paper's equation 8.
    Table<std::array<float, kCoefficients>> coefficients;
    /// Mean radiance, W m^-2 sr^-1 nm^-1.
    Table<float> radiance;
};

/// Bands from kHosekWilkieFirstNm on.
inline constexpr double kHosekWilkieFirstNm = 360, kHosekWilkieStepNm = 40;
using HosekWilkieData = std::array<HosekWilkieBand, 10>;
extern const HosekWilkieData kHosekWilkieData;

}  // namespace lxs
