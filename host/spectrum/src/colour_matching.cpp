// From spectra to linear RGB: the standard observer and the primaries of Rec. 709.
#include "lxs/spectrum/colour_matching.h"

#include <algorithm>
#include <cmath>

#include "observer_table.h"

namespace lxs {
namespace {

/// Sum of each channel over the visible range, at steps of a nanometre.
Imath::V3d flat_spectrum() {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += rgb_of_xyz(colour_matching(nm));
    return sum;
}

Imath::V3d row(std::size_t i) {
    return {kObserverTable[i][0], kObserverTable[i][1], kObserverTable[i][2]};
}

}  // namespace

Imath::V3d colour_matching(double nm) {
    const double place = (nm - kObserverFirstNm) / kObserverStepNm;
    const auto last = static_cast<double>(kObserverTable.size() - 1);
    if (!(place >= 0 && place <= last)) return Imath::V3d(0.0);
    const auto below = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
    const double share = place - static_cast<double>(below);
    return row(below) * (1 - share) + row(below + 1) * share;
}

Imath::V3d rgb_of_xyz(const Imath::V3d& xyz) {
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

Rgb clipped_rgb_of_xyz(const Imath::V3d& xyz) {
    const Imath::V3d rgb = rgb_of_xyz(xyz);
    return Rgb(Imath::V3f(static_cast<float>(std::max(rgb.x, 0.0)),
                          static_cast<float>(std::max(rgb.y, 0.0)),
                          static_cast<float>(std::max(rgb.z, 0.0))));
}

Imath::V3d rgb_response(double nm) {
    static const Imath::V3d flat = flat_spectrum();
    return rgb_of_xyz(colour_matching(nm)) / flat;
}

}  // namespace lxs
