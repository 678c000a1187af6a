// Meshes written out as lists of numbers in the scene.
#pragma once

#include "lxs/scene/geometry.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// P, triindices, N, uv and the like.
std::vector<ParameterDeclaration> list_parameters();

/// The mesh of these lists, checked. Throws InputError, EmptyShape if there is nothing in
/// them.
TriangleMesh read_lists(const ParameterReader& reader);

}  // namespace lxs
