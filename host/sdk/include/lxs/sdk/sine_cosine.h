// Sine and cosine together, inline and in single precision with the same bits on every C library:
// warps take them for every ray, and the general functions of the library cost as much as the rest
// of a warp. Source of the polynomials: Cephes 2.8 (Moshier), sinf.c.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

namespace lxs {

template <class Real>
struct SineCosine {
    Real sine, cosine;
};

/// Of an angle in [-pi/4, pi/4], radians; off by less than 1e-7.
inline SineCosine<float> sine_cosine_of_octant(float x) {
    const float z = x * x;
    const float sine =
        ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * x + x;
    const float cosine =
        ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
        0.5f * z + 1.0f;
    return {sine, cosine};
}
inline SineCosine<double> sine_cosine_of_octant(double x) {
    return {std::sin(x), std::cos(x)};
}

/// Of 2 pi u, for u in [0, 1]; off by less than 2e-7.
inline SineCosine<float> sine_cosine_of_turn(float u) {
    const int quarter = (static_cast<int>(8 * u) + 1) / 2;  // the nearest
    const auto [s, c] = sine_cosine_of_octant((u - 0.25f * static_cast<float>(quarter)) *
                                              (2 * std::numbers::pi_v<float>));
    const SineCosine<float> swapped =
        (quarter & 1) ? SineCosine<float>{c, s} : SineCosine<float>{s, c};
    return {(quarter & 2) ? -swapped.sine : swapped.sine,
            ((quarter + 1) & 2) ? -swapped.cosine : swapped.cosine};
}

}  // namespace lxs
