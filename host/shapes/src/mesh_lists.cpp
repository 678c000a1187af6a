// Meshes written out as lists of numbers in the scene.
#include "mesh_lists.h"

#include <fmt/format.h>

#include <cmath>

#include "empty_shape.h"
#include "mesh_data.h"

namespace lxs {
namespace {

void check_multiple(const ParameterReader& reader, std::string_view name, std::size_t count,
                    std::size_t group) {
    if (count % group == 0) return;
    reader.fail(name, fmt::format("\"{}\" has {} values, which is not a multiple of {}", name,
                                  count, group));
}

Vec3 vector_at(std::span<const double> numbers, std::size_t i) {
    return {static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]),
            static_cast<float>(numbers[i + 2])};
}

std::vector<Vec3> read_positions(const ParameterReader& reader) {
    const std::span<const double> numbers = reader.numbers("P");
    std::vector<Vec3> positions;
    positions.reserve(numbers.size() / 3 + 1);  // for one more, which the kernel may read
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        positions.push_back(vector_at(numbers, i));
    return positions;
}

/// Numbers of a list that has `each` a vertex; none, with a message, if their number is another: as
/// in LuxRender the mesh does without them.
std::span<const double> vertex_values(const ParameterReader& reader, std::string_view name,
                                      std::size_t each, std::size_t vertex_count) {
    const std::span<const double> numbers = reader.numbers(name);
    if (numbers.empty() || numbers.size() == each * vertex_count) return numbers;
    reader.diagnostics().fallback(
        reader.where(name),
        fmt::format("\"{}\" has {} values, but \"P\" has {} vertices: expected {}",
                    reader.spelling(name), numbers.size(), vertex_count, each * vertex_count),
        "it is left out");
    return {};
}

MeshSource list_source(const ParameterReader& reader, std::string_view name) {
    return {reader, name, fmt::format("\"{}\"", reader.spelling(name))};
}

/// The list `name`, `corners` vertices a face, cut into triangles (0, k, k + 1) and appended.
void append_faces(const ParameterReader& reader, std::string_view name, std::size_t corners,
                  std::size_t vertex_count, std::vector<std::uint32_t>& indices) {
    const std::span<const double> numbers = reader.numbers(name);
    check_multiple(reader, name, numbers.size(), corners);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double index = numbers[i];
        if (index >= 0 && index < static_cast<double>(vertex_count) && index == std::floor(index))
            continue;
        reader.fail(name,
                    fmt::format("\"{}\" names vertex {} at position {} ({} {}), but \"P\" has "
                                "{} vertices, numbered from 0",
                                name, index, i, corners == 3 ? "triangle" : "quadrilateral",
                                i / corners, vertex_count));
    }
    indices.reserve(indices.size() + numbers.size() / corners * (corners - 2) * 3);
    for (std::size_t face = 0; face < numbers.size(); face += corners) {
        for (std::size_t k = 1; k + 1 < corners; ++k) {
            for (const std::size_t corner : {std::size_t{0}, k, k + 1})
                indices.push_back(static_cast<std::uint32_t>(numbers[face + corner]));
        }
    }
}

/// What the vertices have beside their positions.
void read_attributes(const ParameterReader& reader, TriangleMesh& mesh) {
    const std::size_t count = mesh.positions.size();
    const std::span<const double> normals = vertex_values(reader, "N", 3, count);
    for (std::size_t i = 0; i < normals.size(); i += 3)
        mesh.normals.push_back(vector_at(normals, i));
    const std::span<const double> uvs = vertex_values(reader, "uv", 2, count);
    for (std::size_t i = 0; i < uvs.size(); i += 2)
        mesh.uvs.emplace_back(static_cast<float>(uvs[i]), static_cast<float>(uvs[i + 1]));
    const std::span<const double> colors = vertex_values(reader, "C", 3, count);
    for (std::size_t i = 0; i < colors.size(); i += 3)
        mesh.colors.push_back(vector_at(colors, i));
    for (const double alpha : vertex_values(reader, "alpha", 1, count))
        mesh.alphas.push_back(static_cast<float>(alpha));
    mend_normals(mesh, list_source(reader, "N"));
    mend_coordinates(mesh, list_source(reader, "uv"));
    mend_colors(mesh, list_source(reader, "C"));
    mend_alphas(mesh, list_source(reader, "alpha"));
    apply_gamma(mesh.colors, static_cast<float>(reader.number("gamma", 1)));
}

}  // namespace

std::vector<ParameterDeclaration> list_parameters() {
    using enum ParameterType;
    const auto list = [](std::string_view name, ParameterType type, std::string_view doc) {
        ParameterDeclaration declaration{name, type, "", doc};
        declaration.array = true;
        return declaration;
    };
    const auto past = [&](std::string_view name, ParameterType type, std::string_view doc) {
        ParameterDeclaration declaration = list(name, type, doc);
        declaration.no_effect = true;
        return declaration;
    };
    const auto renamed = [](ParameterDeclaration declaration, std::string_view older_name) {
        declaration.older_name = older_name;
        return declaration;
    };
    const auto any = [](ParameterDeclaration declaration) {
        declaration.holds_any_number = true;
        return declaration;
    };
    return {
        any(list("P", Point, "Vertex positions.")),
        renamed(list("triindices", Integer, "Vertices of the triangles, three each, from 0."),
                "indices"),
        list("quadindices", Integer, "Vertices of quadrilaterals, four each, from 0."),
        any(list("N", Normal, "Vertex normals, one for each position.")),
        any(renamed(list("uv", Float, "Texture coordinates, a pair for each position."), "st")),
        any(list("C", Color, "Vertex colours, which hitpointcolor and hitpointgrey read.")),
        any(renamed(list("alpha", Float, "Vertex opacities, which hitpointalpha reads."), "A")),
        {"gamma", Float, "1", "Exponent of the vertex colours.", 0},
        past("ntris", Integer, "Number of triangles; the list tells it."),
        past("nvertices", Integer, "Number of vertices; the list tells it."),
    };
}

TriangleMesh read_lists(const ParameterReader& reader) {
    TriangleMesh mesh;
    mesh.positions = read_positions(reader);
    if (!reader.given("P")) reader.fail("P", "a mesh needs vertex positions: \"point P\" [...]");
    if (mesh.positions.empty()) fail_empty(reader, "P", "the mesh has no vertices");
    const std::size_t vertex_count = mesh.positions.size();
    const std::string_view triangles = reader.spelling("triindices");
    append_faces(reader, triangles, 3, vertex_count, mesh.indices);
    append_faces(reader, "quadindices", 4, vertex_count, mesh.indices);
    if (!reader.given(triangles) && !reader.given("quadindices"))
        reader.fail(triangles, "a mesh needs triangles: \"integer triindices\" [...]");
    if (mesh.indices.empty()) fail_empty(reader, triangles, "the mesh has no triangles");
    mend_positions(mesh, list_source(reader, "P"));
    read_attributes(reader, mesh);
    return mesh;
}

}  // namespace lxs
