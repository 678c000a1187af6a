// Triangles of a PLY file as scripts/big-scenes writes it, and Embree's hierarchy of them.
#pragma once

#include <cstdint>
#include <vector>

#include "lxs/embree/queries.h"

namespace big_scenes {

struct Mesh {
    std::vector<float> positions;  ///< x, y, z, and a vertex behind the last that Embree may read
    std::vector<std::uint32_t> corners;
    std::size_t vertices = 0;
};

/// Throws std::exception when the file is no such file, or too short.
Mesh read_mesh(const char* path);

/// An empty scene with the flags of the host.
RTCScene new_scene(RTCDevice device);

/// A scene of the mesh, whose arrays it reads in place.
RTCScene build_mesh(RTCDevice device, const Mesh& mesh);

/// Hands the geometry over to the scene.
void attach(RTCScene scene, RTCGeometry geometry);

}  // namespace big_scenes
