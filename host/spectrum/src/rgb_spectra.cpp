// Spectra that stand for colours in linear RGB as LuxRender carries them.
#include "lxs/spectrum/rgb_spectra.h"

#include <algorithm>
#include <cmath>

#include "colour_bases.h"
#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

double at(const SpectralBase& base, double nm) {
    if (!(nm >= kBaseFirstNm && nm <= kBaseLastNm)) return 0;
    const auto last = static_cast<double>(base.size() - 1);
    const double place = (nm - kBaseFirstNm) / (kBaseLastNm - kBaseFirstNm) * last;
    const auto below = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
    return std::lerp(base[below], base[below + 1], place - static_cast<double>(below));
}

/// Of which LuxRender's light of L 1 1 1 has luminance 1.
double illuminant_scale() {
    static const double scale = [] {
        double white = 0, flat = 0;
        for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm) {
            white += colour_matching(nm).y * at(kIlluminantBases[0], nm);
            flat += colour_matching(nm).y;
        }
        return flat / white;
    }();
    return scale;
}

template <class Spectrum>
Imath::V3d colour_of(const Spectrum& spectrum) {
    Imath::V3d sum(0.0);
    for (double nm = kBaseFirstNm; nm <= kBaseLastNm; ++nm)
        sum += rgb_of_xyz(colour_matching(nm)) * spectrum(nm);
    return sum;
}

using LinearColours = std::array<Imath::V3d, kColourBases>;

/// LinearColours of the base spectra, relative to that of white.
const LinearColours& colours_of_illuminants() {
    static const LinearColours colours = [] {
        LinearColours c;
        for (std::size_t i = 0; i < kColourBases; ++i)
            c[i] = colour_of([i](double nm) { return illuminant_base(i, nm); });
        for (std::size_t i = kColourBases; i-- > 0;)
            c[i] /= c[0];
        return c;
    }();
    return colours;
}

/// The same of the products of filters (first index) and lights.
const std::array<LinearColours, kColourBases>& colours_of_products() {
    static const std::array<LinearColours, kColourBases> colours = [] {
        std::array<LinearColours, kColourBases> c;
        for (std::size_t i = 0; i < kColourBases; ++i) {
            for (std::size_t k = 0; k < kColourBases; ++k) {
                c[i][k] = colour_of(
                    [&](double nm) { return reflectance_base(i, nm) * illuminant_base(k, nm); });
            }
        }
        const Imath::V3d white = c[0][0];
        for (LinearColours& row : c) {
            for (Imath::V3d& colour : row)
                colour /= white;
        }
        return c;
    }();
    return colours;
}

Rgb not_negative(const Imath::V3d& c) {
    const auto clip = [](double v) { return static_cast<float>(std::max(v, 0.0)); };
    return Rgb(clip(c.x), clip(c.y), clip(c.z));
}

bool is_grey(const Rgb& c) {
    return c.x == c.y && c.y == c.z;
}

}  // namespace

ColourParts parts_of(const Rgb& colour) {
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return colour[int(a)] < colour[int(b)]; });
    const double least = colour[int(order[0])], middle = colour[int(order[1])];
    ColourParts parts{};
    parts[0] = least;
    parts[1 + order[0]] = middle - least;  // what lacks the least channel alone
    parts[4 + order[2]] = double{colour[int(order[2])]} - middle;
    return parts;
}

double reflectance_base(std::size_t base, double nm) {
    return at(kReflectanceBases[base], nm) * kReflectanceScale;
}

double illuminant_base(std::size_t base, double nm) {
    return at(kIlluminantBases[base], nm) * illuminant_scale();
}

Rgb colour_of_illuminant(const Rgb& colour) {
    if (is_grey(colour)) return colour;
    const ColourParts parts = parts_of(colour);
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < kColourBases; ++i)
        sum += colours_of_illuminants()[i] * parts[i];
    return not_negative(sum);
}

Rgb illuminant_of_colour(const Rgb& colour) {
    if (is_grey(colour)) return colour;
    // The colour differs from L by a few percent: what is missing shrinks as fast with each step.
    Imath::V3d l(colour);
    for (int step = 0; step < 16; ++step)
        l += Imath::V3d(colour) - Imath::V3d(colour_of_illuminant(not_negative(l)));
    return not_negative(l);
}

Rgb colour_of_filtered_illuminant(const Rgb& filter, const Rgb& illuminant) {
    if (is_grey(filter)) return colour_of_illuminant(illuminant) * filter.x;
    const ColourParts f = parts_of(filter), light = parts_of(illuminant);
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < kColourBases; ++i) {
        for (std::size_t k = 0; k < kColourBases; ++k)
            sum += colours_of_products()[i][k] * (f[i] * light[k]);
    }
    return not_negative(sum);
}

}  // namespace lxs
