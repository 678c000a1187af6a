// Mesh data on its way from a scene or file to a TriangleMesh: checks and completion.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lxs/scene/geometry.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// Coordinates with a larger absolute value are refused: the ray-tracing kernel drops them
/// silently.
inline constexpr float kLargestCoordinate = 1e18f;

/// Where mesh data comes from, for messages: `label` is the parameter or file as a message names
/// it.
struct MeshSource {
    const ParameterReader& reader;
    std::string_view parameter;
    std::string label;
};

/// Throws InputError for a vector that isn't finite or is beyond kLargestCoordinate; `noun` is what
/// one of them is called ("vertex", "normal").
void check_vectors(const std::vector<Vec3>& vectors, std::string_view noun,
                   const MeshSource& source);

/// Throws InputError for texture coordinates that aren't finite.
void check_coordinates(const std::vector<Vec2>& uvs, const MeshSource& source);

/// Per vertex, the mean of the unit normals of its triangles (all alike, as LuxRender does); +z
/// where there are none.
std::vector<Vec3> smooth_normals(const std::vector<Vec3>& positions,
                                 const std::vector<std::uint32_t>& indices);

/// Turns checked data in the shape's own space into a mesh in the enclosing object's: transforms,
/// leaves out triangles without area (a warning counts them), makes normals unit and replaces zero
/// ones by smooth_normals. Throws InputError if the transform moves a vertex out of range,
/// EmptyShape if no triangle has an area.
TriangleMesh finish_mesh(TriangleMesh mesh, const Matrix& to_world, const ParameterReader& reader);

/// Declarations of what LuxRender knows of meshes and this host reads past.
std::vector<ParameterDeclaration> compatibility_parameters();

}  // namespace lxs
