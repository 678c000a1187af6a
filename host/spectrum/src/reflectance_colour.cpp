// Colours of reflectances as LuxRender renders them under its white light.
#include "lxs/spectrum/reflectance_colour.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {
namespace {

constexpr std::size_t kWhite = 0;  // of the bases

Imath::V3d lamp_colour(double nm) {
    return rgb_of_xyz(colour_matching(nm)) * illuminant_base(kWhite, nm);
}

Imath::V3d colour_of_lamp() {
    Imath::V3d sum(0.0);
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        sum += lamp_colour(nm);
    return sum;
}

using Colours = std::array<Rgb, kColourBases>;

/// Of the base spectra, relative to that of white.
Colours colours_of_bases() {
    std::array<Imath::V3d, kColourBases> sums;
    sums.fill(Imath::V3d(0.0));
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
        for (std::size_t i = 0; i < kColourBases; ++i)
            sums[i] += white_lamp_response(nm) * reflectance_base(i, nm);
    }
    Colours colours;
    for (std::size_t i = 0; i < kColourBases; ++i)
        colours[i] = Rgb(Imath::V3f(sums[i] / sums[kWhite]));
    return colours;
}

}  // namespace

Imath::V3d white_lamp_response(double nm) {
    static const Imath::V3d white = colour_of_lamp();
    return lamp_colour(nm) / white;
}

Rgb colour_of_reflectance(const Rgb& rgb) {
    if (rgb.x == rgb.y && rgb.y == rgb.z) return rgb;
    static const Colours colours = colours_of_bases();
    int least = 0, middle = 1, most = 2;
    if (rgb[least] > rgb[middle]) std::swap(least, middle);
    if (rgb[middle] > rgb[most]) std::swap(middle, most);
    if (rgb[least] > rgb[middle]) std::swap(least, middle);
    // As parts_of() has it, which has no need to be fast.
    const Rgb& pair = colours[1 + static_cast<std::size_t>(least)];
    const Rgb& pure = colours[4 + static_cast<std::size_t>(most)];
    return Rgb(rgb[least]) + pair * (rgb[middle] - rgb[least]) + pure * (rgb[most] - rgb[middle]);
}

Rgb reflectance_of_colour(const Rgb& seen) {
    if (seen.x == seen.y && seen.y == seen.z) return seen;
    constexpr int kSteps = 4;  // each leaves less than a tenth of the difference
    Rgb written = seen;
    for (int step = 0; step < kSteps; ++step) {
        const Rgb miss = seen - colour_of_reflectance(written);
        for (int c = 0; c < 3; ++c)
            written[c] = std::max(written[c] + miss[c], 0.0f);
    }
    return written;
}

}  // namespace lxs
