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
    // Inverse of the matrix that kSceneRed ... kSceneWhite span (SMPTE RP 177).
    return {3.2224537 * xyz.x - 1.5285999 * xyz.y - 0.4957621 * xyz.z,
            -0.9705547 * xyz.x + 1.8785052 * xyz.y + 0.0416113 * xyz.z,
            0.0558278 * xyz.x - 0.2047020 * xyz.y + 1.0607287 * xyz.z};
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
