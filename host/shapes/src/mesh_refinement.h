// Subdivision and displacement as mesh statements ask for them.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs {

/// The parameters of `refine`; `levels` is the name and default of the number of levels.
std::vector<ParameterDeclaration> refinement_parameters(std::string_view levels,
                                                        std::string_view default_levels);

/// `mesh`, which is in the shape's own space, subdivided and displaced. `to_world` says where the
/// displacement's texture is looked up.
TriangleMesh refine(TriangleMesh mesh, const ParameterReader& reader, const AssetContext& assets,
                    const Matrix& to_world, std::string_view levels, std::int64_t default_levels);

}  // namespace lxs
