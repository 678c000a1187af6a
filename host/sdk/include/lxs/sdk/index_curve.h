// Index of refraction over the visible spectrum.
#pragma once

#include <array>

#include "lxs/sdk/types.h"

namespace lxs {

/// The wavelength whose index stands for all where light is not dispersed, nanometres.
inline constexpr double kMiddleNm = 550;

/// Cauchy's formula n = a + b / w^2 + c / w^4, the wavelength w in micrometres.
struct IndexCurve {
    double a = 1, b = 0, c = 0;

    float at(double nm) const {
        const double inverse = 1e6 / (nm * nm);
        return static_cast<float>(a + inverse * (b + inverse * c));
    }
    bool varies() const { return b != 0 || c != 0; }
};

/// The curve through three indices `n`, given at the wavelengths `nm`, which must differ.
inline IndexCurve index_curve_through(const std::array<double, 3>& nm, const Rgb& n) {
    // Newton's divided differences in 1 / w^2.
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i)
        x[i] = 1e6 / (nm[i] * nm[i]);
    const double first = (double(n.y) - n.x) / (x[1] - x[0]);
    const double second = (double(n.z) - n.y) / (x[2] - x[1]);
    const double c = (second - first) / (x[2] - x[0]);
    const double b = first - c * (x[0] + x[1]);
    return {n.x - x[0] * (b + x[0] * c), b, c};
}

}  // namespace lxs
