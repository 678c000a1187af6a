// Subdivision and displacement as mesh statements ask for them.
#include "mesh_refinement.h"

#include <fmt/format.h>

#include <cmath>

#include "mesh_data.h"
#include "subdivision.h"

namespace lxs {
namespace {

constexpr std::array<std::string_view, 2> kSchemes = {"loop", "microdisplacement"};
constexpr double kMostTriangles = 1e7;  // of one shape: some 100 bytes each while it is split

/// As many levels as asked for, or as many as keep within kMostTriangles, with a warning.
int affordable(std::int64_t levels, std::size_t triangles, const ParameterReader& reader,
               std::string_view name) {
    std::int64_t possible = 0;
    for (double count = static_cast<double>(triangles); possible < levels; ++possible) {
        count *= 4;
        if (count > kMostTriangles) break;
    }
    if (possible < levels) {
        reader.diagnostics().warning(
            reader.where(name), fmt::format("{} levels of subdivision would make more than {:g} "
                                            "triangles of {}: {} are used",
                                            levels, kMostTriangles, triangles, possible));
    }
    return static_cast<int>(possible);
}

/// Levels of halving that give at least `parts` to an edge.
std::int64_t halvings(std::int64_t parts) {
    std::int64_t levels = 0;
    while ((std::int64_t{1} << levels) < parts && levels < 30)
        ++levels;
    return levels;
}

std::shared_ptr<const FloatTexture> displacement_map(const ParameterReader& reader,
                                                     const AssetContext& assets) {
    constexpr std::string_view kName = "displacementmap";
    const auto name = reader.texture_name(kName);
    return name && !name->empty() ? assets.float_texture(*name, reader.where(kName)) : nullptr;
}

void displace(TriangleMesh& mesh, const FloatTexture& map, double scale, double offset,
              const Matrix& to_world) {
    const Matrix normals_to_world = to_world.inverse().transposed();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Imath::V3d p, n;
        to_world.multVecMatrix(Imath::V3d(mesh.positions[i]), p);
        normals_to_world.multDirMatrix(Imath::V3d(mesh.normals[i]), n);
        TexturePoint point;
        point.p = Vec3(p);
        point.n = Vec3(n.normalized());
        if (!mesh.uvs.empty()) point.uv = mesh.uvs[i];
        if (!mesh.colors.empty()) point.color = mesh.colors[i];
        if (!mesh.alphas.empty()) point.alpha = mesh.alphas[i];
        const double height = offset + scale * static_cast<double>(map.evaluate(point));
        if (std::isfinite(height)) mesh.positions[i] += mesh.normals[i] * float(height);
    }
}

/// smooth_normals that treat vertices at one place as one.
std::vector<Vec3> merged_normals(const TriangleMesh& mesh, bool merge) {
    if (!merge) return smooth_normals(mesh.positions, mesh.indices);
    const std::vector<std::uint32_t> place = places_of(mesh.positions);
    std::vector<std::uint32_t> corners(mesh.indices);
    for (std::uint32_t& corner : corners)
        corner = place[corner];
    const std::vector<Vec3> of_place = smooth_normals(mesh.positions, corners);
    std::vector<Vec3> normals;
    normals.reserve(place.size());
    for (const std::uint32_t p : place)
        normals.push_back(of_place[p]);
    return normals;
}

}  // namespace

std::vector<ParameterDeclaration> refinement_parameters(std::string_view levels,
                                                        std::string_view default_levels) {
    using enum ParameterType;
    return {
        {levels, Integer, default_levels,
         "Levels of subdivision; with \"microdisplacement\", parts of each edge (made a power of "
         "two).",
         0},
        {"displacementmap", FloatTexture, "",
         "Moves vertices along their normals by dmoffset + dmscale times its value; named as a "
         "string, as in LuxRender, or as a texture."},
        {"subdivscheme", String, "loop",
         "\"loop\": Loop subdivision; \"microdisplacement\": triangles are split, not smoothed.", 0,
         0, kSchemes},
        {"dmscale", Float, "0.1", "Scale of the displacement."},
        {"dmoffset", Float, "0", "Offset of the displacement."},
        {"dmnormalsmooth", Bool, "true",
         "Smooth normals of the displaced mesh; else its triangles are flat."},
        {"dmnormalsplit", Bool, "false",
         "Vertices at one place stay apart: the surface breaks there."},
        {"dmsharpboundary", Bool, "false", "Open boundaries keep their shape in subdivision."},
    };
}

TriangleMesh refine(TriangleMesh mesh, const ParameterReader& reader, const AssetContext& assets,
                    const Matrix& to_world, std::string_view levels, std::int64_t default_levels) {
    const auto map = displacement_map(reader, assets);
    const bool micro = reader.string("subdivscheme", "loop") == "microdisplacement";
    constexpr std::int64_t kMicroParts = 50;
    std::int64_t asked = reader.integer(levels, micro && map ? kMicroParts : default_levels);
    if (micro) asked = halvings(asked);
    SubdivisionRules rules;
    rules.smooth = !micro;
    rules.sharp_boundary = reader.boolean("dmsharpboundary", false);
    rules.merge = !reader.boolean("dmnormalsplit", false);
    const int count = affordable(asked, mesh.indices.size() / 3, reader, levels);
    if (map && micro && mesh.normals.empty()) mesh.normals = merged_normals(mesh, rules.merge);
    if (count > 0) mesh = subdivide(mesh, count, rules);
    if (!map) return mesh;
    if (mesh.normals.empty()) mesh.normals = merged_normals(mesh, rules.merge);
    for (Vec3& normal : mesh.normals)
        normal = Vec3(Imath::V3d(normal).normalized());
    displace(mesh, *map, reader.number("dmscale", 0.1), reader.number("dmoffset", 0), to_world);
    const bool smooth = reader.boolean("dmnormalsmooth", true);
    mesh.normals = smooth ? merged_normals(mesh, rules.merge) : std::vector<Vec3>();
    return mesh;
}

}  // namespace lxs
