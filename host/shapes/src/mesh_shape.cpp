// Meshes written out in the scene: mesh, trianglemesh and LuxRender's other names for it.
#include "mesh_data.h"
#include "mesh_lists.h"
#include "mesh_refinement.h"
#include "shape_factories.h"

namespace lxs {
namespace {

Geometry create_mesh(const ParameterReader& reader, const AssetContext& assets,
                     const Matrix& to_world) {
    TriangleMesh mesh = read_lists(reader);
    if (reader.boolean("discardmeshnormals", false)) mesh.normals.clear();
    return finish_mesh(refine(std::move(mesh), reader, assets, to_world, "nsubdivlevels", 0),
                       to_world, reader);
}

}  // namespace

ShapeFactory make_mesh_factory() {
    std::vector<ParameterDeclaration> parameters = list_parameters();
    for (const auto& more :
         {refinement_parameters("nsubdivlevels", "0"), compatibility_parameters()})
        parameters.insert(parameters.end(), more.begin(), more.end());
    return {parameters, create_mesh};
}

}  // namespace lxs
