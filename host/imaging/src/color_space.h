// The film's colour space.
#pragma once

#include <array>

#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {

/// Chromaticities x, y of the primaries and of white; by default LuxRender's film, SMPTE "C".
struct ColorSpace {
    std::array<double, 2> red{0.63, 0.34}, green{0.31, 0.595}, blue{0.155, 0.07};
    std::array<double, 2> white{0.314275, 0.329411};
    bool operator==(const ColorSpace&) const = default;
};

/// In which scenes give their colours.
inline constexpr ColorSpace kSceneColors{kSceneRed, kSceneGreen, kSceneBlue, kSceneWhite};

/// Linear RGB of one space, as a row, times this is that of another: through XYZ, without
/// adaptation to the other's white. Throws std::invalid_argument if the primaries of one lie on a
/// line or its white is no colour.
Imath::M33d rgb_matrix(const ColorSpace& from, const ColorSpace& to);

/// `c` times `m`, colours outside of the space clipped to its border.
Rgb converted(const Imath::M33d& m, const Rgb& c);

}  // namespace lxs
