// White light: standard illuminant D65.
#include "lxs/spectrum/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

constexpr double kTableFirstNm = 380, kTableStepNm = 10;

// CIE 15:2004, table T.1: relative power from 380 to 780 nm, linear in between by definition.
constexpr std::array<double, 41> kD65 = {
    49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812,
    114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
    100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
    80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856,
    75.0870, 63.5927, 46.4182, 66.8054, 63.3828};

/// At the table's ends their values hold: nobody sees beyond.
double relative_power(double nm) {
    const double last = static_cast<double>(kD65.size() - 1);
    const double place = std::clamp((nm - kTableFirstNm) / kTableStepNm, 0.0, last);
    const auto below = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
    const double share = place - static_cast<double>(below);
    return kD65[below] * (1 - share) + kD65[below + 1] * share;
}

struct Scale {
    double daylight = 0;       ///< luminance of D65 as tabulated over that of a flat spectrum
    Imath::V3d response{0.0};  ///< sum of each channel under D65 as tabulated
};

Scale sum_up() {
    Scale scale;
    double flat = 0;
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        const Imath::V3d xyz = colour_matching(nm);
        scale.daylight += xyz.y * relative_power(nm);
        scale.response += rgb_of_xyz(xyz) * relative_power(nm);
        flat += xyz.y;
    }
    scale.daylight /= flat;
    return scale;
}

const Scale& scale() {
    static const Scale value = sum_up();
    return value;
}

}  // namespace

double daylight(double nm) {
    return relative_power(nm) / scale().daylight;
}

Imath::V3d daylight_response(double nm) {
    return rgb_of_xyz(colour_matching(nm)) * relative_power(nm) / scale().response;
}

}  // namespace lxs
