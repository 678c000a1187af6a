// Triangle meshes from PLY data.
#pragma once

#include <string_view>

#include "lxs/scene/geometry.h"

namespace lxs {

/// The mesh of a PLY file's text: vertices with what they carry of normals, coordinates, colours
/// (bytes as 0 to 1) and opacities; faces cut into fans. Nothing is checked but the faces'
/// vertices. Throws std::runtime_error that completes "the file can't be read: ".
TriangleMesh read_ply_mesh(std::string_view file);

}  // namespace lxs
