// Triangle meshes from STL data.
#pragma once

#include <string_view>

#include "lxs/scene/geometry.h"

namespace lxs {

/// The facets of an STL file, text or binary, three vertices each; their normals are left to the
/// corners' order. Throws std::runtime_error that completes "the file can't be read: ".
TriangleMesh read_stl_mesh(std::string_view file);

}  // namespace lxs
