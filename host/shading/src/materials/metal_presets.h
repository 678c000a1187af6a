// Measured optical constants of metals, by LuxRender's names.
#pragma once

#include <array>
#include <vector>

#include "lxs/scene/registry.h"

namespace lxs::shading {

/// Wavelengths that stand for red, green and blue, nanometres.
inline constexpr std::array<float, 3> kRgbWavelengths{650, 532, 450};

/// Declarations of "name" and "filename".
std::vector<ParameterDeclaration> metal_preset_parameters();

/// Constants of the metal that "name" says (default aluminium), or of the file in "filename".
/// An unknown name is warned of and taken for the default; throws InputError for a file that
/// isn't a table.
FresnelValue read_metal_preset(const ParameterReader& reader, const AssetContext& assets);

}  // namespace lxs::shading
