// From spectra to linear RGB: the standard observer and the primaries of Rec. 709.
#include "lxs/spectrum/colour_matching.h"

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

double lobe(double wavelength, double mean, double below, double above) {
    const double t = (wavelength - mean) * (wavelength < mean ? below : above);
    return std::exp(-0.5 * t * t);
}

/// Sum of each channel over the visible range, at steps of a nanometre.
Imath::V3d flat_spectrum() {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += rgb_of_xyz(colour_matching(nm));
    return sum;
}

}  // namespace

Imath::V3d colour_matching(double nm) {
    return {1.056 * lobe(nm, 599.8, 0.0264, 0.0323) + 0.362 * lobe(nm, 442.0, 0.0624, 0.0374) -
                0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
            0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
            1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
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
