// LuxRender's ways from colours to spectra and from spectra to light, written out for tests: Smits'
// cases, the eye, and the matrix of the scene's primaries.
#pragma once

#include <cmath>
#include <functional>

#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs::test {

using Curve = std::function<double(double nm)>;

/// Chromaticity to XYZ of luminance 1.
inline Imath::V3d xyz_of(const std::array<double, 2>& c) {
    return {c[0] / c[1], 1, (1 - c[0] - c[1]) / c[1]};
}

/// XYZ to linear RGB of the scene's primaries and white.
inline Imath::V3d scene_rgb(const Imath::V3d& xyz) {
    const Imath::V3d r = xyz_of(kSceneRed), g = xyz_of(kSceneGreen), b = xyz_of(kSceneBlue);
    const Imath::M33d inverse = Imath::M33d(r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z).inverse();
    return xyz * inverse / (xyz_of(kSceneWhite) * inverse);
}

/// LuxRender's film: 380 to 720 nm by the observer, per unit of a flat spectrum's luminance.
inline Imath::V3d film_xyz(const Curve& spectrum) {
    Imath::V3d sum(0.0);
    double flat = 0;
    for (double nm = 360; nm <= 830; ++nm) {
        if (nm >= 380 && nm <= 720) sum += colour_matching(nm) * spectrum(nm);
        flat += colour_matching(nm).y;
    }
    return sum / flat;
}

/// Smits' nine cases over a set of base spectra.
template <class Base>
Curve smits(const Base& base, double r, double g, double b) {
    enum { White, Cyan, Magenta, Yellow, Red, Green, Blue };
    const auto sum = [&base](double least, std::size_t second, double middle, std::size_t third,
                             double most) {
        return [=](double nm) {
            return least * base(White, nm) + (middle - least) * base(second, nm) +
                   (most - middle) * base(third, nm);
        };
    };
    if (r <= g && r <= b) return g <= b ? sum(r, Cyan, g, Blue, b) : sum(r, Cyan, b, Green, g);
    if (g <= r && g <= b) return r <= b ? sum(g, Magenta, r, Blue, b) : sum(g, Magenta, b, Red, r);
    return r <= g ? sum(b, Yellow, r, Green, g) : sum(b, Yellow, g, Red, r);
}

/// The light of an L; negative values of the spectrum are 0.
inline Curve illuminant(const Rgb& l) {
    const Curve spectrum = smits(illuminant_base, l.x, l.y, l.z);
    return [=](double nm) { return std::max(spectrum(nm), 0.0); };
}

/// A pixel of a map.
inline Curve filter(const Rgb& c) {
    return smits(reflectance_base, c.x, c.y, c.z);
}

inline Imath::V3d light_colour(const Rgb& l) {
    return scene_rgb(film_xyz(illuminant(l)));
}

/// Its luminance, which LuxRender divides powers by: of what lies in the gamut, which for pure blue
/// is 2 % more than of the spectrum, for all else less than 0.4 %.
inline double light_luminance(const Rgb& l) {
    const Imath::V3d c = light_colour(l);
    return luminance(Rgb(Imath::V3d(std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0))));
}

}  // namespace lxs::test
