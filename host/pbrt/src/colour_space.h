// The colour spaces in which a scene of pbrt writes RGB.
#pragma once

#include <string>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs::pbrt {

struct ColourSpace {
    std::string name;
    Imath::M33d to_linear;  ///< row vector of its RGB times this: linear RGB of Rec. 709
};

/// Null for an unknown name.
const ColourSpace* colour_space(const std::string& name);
const ColourSpace& srgb();
std::vector<std::string> colour_space_names();

/// A light's colour, whose white is that of the space.
Rgb light_in(const ColourSpace& space, const Rgb& rgb);
/// A reflectance: white stays white.
Rgb surface_in(const ColourSpace& space, const Rgb& rgb);

}  // namespace lxs::pbrt
