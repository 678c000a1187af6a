// Height fields, and control meshes given for subdivision.
#include <fmt/format.h>

#include "mesh_data.h"
#include "mesh_lists.h"
#include "mesh_refinement.h"
#include "shape_factories.h"

namespace lxs {
namespace {

std::size_t grid_side(const ParameterReader& reader, std::string_view name) {
    const std::int64_t side = reader.integer(name, 0);
    if (side < 2)
        reader.fail(name, fmt::format("\"{}\" is {}: a height field needs at least 2", name, side));
    return static_cast<std::size_t>(side);
}

/// Heights over the unit square, u first.
Geometry create_heightfield(const ParameterReader& reader, const AssetContext& assets,
                            const Matrix& to_world) {
    const std::size_t nu = grid_side(reader, "nu"), nv = grid_side(reader, "nv");
    const std::span<const double> heights = reader.numbers("Pz");
    if (heights.size() / nu != nv || heights.size() % nu != 0) {
        reader.fail("Pz", fmt::format("\"Pz\" has {} values: expected nu * nv = {} * {}",
                                      heights.size(), nu, nv));
    }
    TriangleMesh mesh;
    for (std::size_t v = 0; v < nv; ++v) {
        for (std::size_t u = 0; u < nu; ++u) {
            const Vec2 uv(static_cast<float>(u) / static_cast<float>(nu - 1),
                          static_cast<float>(v) / static_cast<float>(nv - 1));
            mesh.uvs.push_back(uv);
            mesh.positions.emplace_back(uv.x, uv.y, static_cast<float>(heights[v * nu + u]));
        }
    }
    for (std::size_t v = 0; v + 1 < nv; ++v) {
        for (std::size_t u = 0; u + 1 < nu; ++u) {
            const auto corner = static_cast<std::uint32_t>(v * nu + u);
            const auto above = corner + static_cast<std::uint32_t>(nu);
            mesh.indices.insert(mesh.indices.end(),
                                {corner, corner + 1, above + 1, corner, above + 1, above});
        }
    }
    mend_positions(mesh, {reader, "Pz", "\"Pz\""});
    return finish_mesh(refine(std::move(mesh), reader, assets, to_world, "nsubdivlevels", 0),
                       to_world, reader);
}

constexpr std::int64_t kLoopLevels = 3;

Geometry create_loopsubdiv(const ParameterReader& reader, const AssetContext& assets,
                           const Matrix& to_world) {
    TriangleMesh mesh = read_lists(reader);
    return finish_mesh(refine(std::move(mesh), reader, assets, to_world, "nlevels", kLoopLevels),
                       to_world, reader);
}

}  // namespace

ShapeFactory make_heightfield_factory() {
    using enum ParameterType;
    std::vector<ParameterDeclaration> parameters = {
        {"nu", Integer, "", "Heights along x, at least 2.", 2},
        {"nv", Integer, "", "Heights along y, at least 2.", 2},
        {.name = "Pz",
         .type = Float,
         .doc = "Heights over the unit square, nu * nv of them, those along x first.",
         .array = true,
         .holds_any_number = true},
        {"name", String, "", "Name of the shape in messages."},
    };
    for (const ParameterDeclaration& more : refinement_parameters("nsubdivlevels", "0"))
        parameters.push_back(more);
    return {parameters, create_heightfield};
}

ShapeFactory make_loopsubdiv_factory() {
    using enum ParameterType;
    std::vector<ParameterDeclaration> parameters = list_parameters();
    ParameterDeclaration scheme{"scheme", String, "loop", "Kind of subdivision; Loop's is used."};
    scheme.no_effect = true;
    parameters.push_back(scheme);
    parameters.push_back({"name", String, "", "Name of the shape in messages."});
    for (const ParameterDeclaration& more : refinement_parameters("nlevels", "3"))
        parameters.push_back(more);
    return {parameters, create_loopsubdiv};
}

}  // namespace lxs
