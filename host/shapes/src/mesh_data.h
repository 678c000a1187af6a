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

/// Throws InputError for a position that is not finite or beyond kLargestCoordinate.
void check_position(const Vec3& position, const MeshSource& source);

/// Leaves out triangles with a vertex that is not finite or beyond kLargestCoordinate, with one
/// message for all of them; vertices that no triangle uses do not matter. Throws InputError if that
/// leaves no triangle. To be called before the other mend functions.
void mend_positions(TriangleMesh& mesh, const MeshSource& source);

/// Gives vertices whose normal is zero or not finite that of their triangles, with one message for
/// those that are not finite.
void mend_normals(TriangleMesh& mesh, const MeshSource& source);

/// Makes texture coordinates that are not finite 0, with one message.
void mend_coordinates(TriangleMesh& mesh, const MeshSource& source);

/// Makes vertex colours that are not finite white, with one message.
void mend_colors(TriangleMesh& mesh, const MeshSource& source);

/// Makes vertex opacities that are not finite 1, with one message.
void mend_alphas(TriangleMesh& mesh, const MeshSource& source);

/// Raises vertex colours to this power, negative ones taken as 0.
void apply_gamma(std::vector<Rgb>& colors, float gamma);

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
