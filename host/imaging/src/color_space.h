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

/// From linear RGB of one space to that of another: through XYZ, without adaptation to the other's
/// white.
class ColorConversion {
  public:
    /// Throws std::invalid_argument if the primaries of one lie on a line or its white is no
    /// colour.
    ColorConversion(const ColorSpace& from, const ColorSpace& to);

    /// A row times it.
    const Imath::M33d& matrix() const { return matrix_; }
    /// How much of luminance R, G and B of the space converted to bring; their sum is 1.
    const Imath::V3d& luminance_weights() const { return luminance_weights_; }
    /// `c` in the other space. What that cannot mix keeps its luminance and takes the nearest
    /// chromaticity between two primaries, as LuxRender's film has it (ColorSystem::Constrain);
    /// black if its luminance isn't positive.
    Rgb operator()(const Rgb& c) const;

  private:
    Rgb constrained(const Imath::V3d& xyz) const;

    ColorSpace to_;
    Imath::M33d matrix_, to_xyz_, from_xyz_;
    Imath::V3d luminance_weights_;
};

}  // namespace lxs
