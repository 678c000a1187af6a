// Emission of shapes from the AreaLightSource statement.
#pragma once

#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"

namespace lxs {

/// Without light group, which is the one in force at each shape. Throws InputError for a name other
/// than "area" and for bad parameters.
AreaEmission make_area_emission(const ParameterSet& set, const AssetContext& assets,
                                Diagnostics& diagnostics);

}  // namespace lxs
