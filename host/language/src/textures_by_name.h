// Parameters that name a texture in ways of their own.
#pragma once

#include "lxs/scene/registry.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// A light other than an area light has one colour: where its "L" or "I" names a texture, the
/// colour that this has at the origin takes its place, with a warning if it varies; where there
/// is no such texture, the value goes.
void evaluate_light_colours(ParameterSet& light, const AssetContext& assets,
                            Diagnostics& diagnostics);

/// LuxRender reads the texture that displaces a shape as "string displacementmap".
void name_displacement_as_texture(ParameterSet& shape);

}  // namespace lxs
