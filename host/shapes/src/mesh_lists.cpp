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

std::vector<Vec3> read_vectors(const ParameterReader& reader, std::string_view name) {
    const std::span<const double> numbers = reader.numbers(name);
    check_multiple(reader, name, numbers.size(), 3);
    std::vector<Vec3> vectors;
    vectors.reserve(numbers.size() / 3 + 1);
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
        vectors.emplace_back(static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]),
                             static_cast<float>(numbers[i + 2]));
    }
    return vectors;
}

std::vector<Vec2> read_coordinates(const ParameterReader& reader, std::string_view name,
                                   std::size_t vertex_count) {
    const std::span<const double> numbers = reader.numbers(name);
    if (numbers.size() != 2 * vertex_count) {
        reader.fail(
            name, fmt::format("\"{}\" has {} values, but \"P\" has {} vertices: expected {}", name,
                              numbers.size(), vertex_count, 2 * vertex_count));
    }
    std::vector<Vec2> uvs;
    uvs.reserve(vertex_count);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        uvs.emplace_back(static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]));
    check_coordinates(uvs, {reader, name, fmt::format("\"{}\"", name)});
    return uvs;
}

std::vector<Vec3> read_normals(const ParameterReader& reader, std::size_t vertex_count) {
    std::vector<Vec3> normals = read_vectors(reader, "N");
    if (normals.size() != vertex_count) {
        reader.fail("N", fmt::format("\"N\" has {} normals, but \"P\" has {} vertices",
                                     normals.size(), vertex_count));
    }
    check_vectors(normals, "normal", {reader, "N", "\"N\""});
    return normals;
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

/// One value per vertex and channel.
void check_count(const ParameterReader& reader, std::string_view name, std::size_t count,
                 std::size_t expected) {
    if (count == expected) return;
    reader.fail(name, fmt::format("\"{}\" has {} values, expected {}", name, count, expected));
}

void read_colors(const ParameterReader& reader, TriangleMesh& mesh) {
    const auto gamma = static_cast<float>(reader.number("gamma", 1));
    const std::span<const double> colors = reader.numbers("C");
    if (!colors.empty()) check_count(reader, "C", colors.size(), 3 * mesh.positions.size());
    for (std::size_t i = 0; i < colors.size(); i += 3) {
        Rgb color;
        for (std::size_t k = 0; k < 3; ++k)
            color[static_cast<int>(k)] =
                std::pow(std::max(0.0f, static_cast<float>(colors[i + k])), gamma);
        mesh.colors.push_back(color);
    }
    const std::span<const double> alphas = reader.numbers("alpha");
    if (!alphas.empty()) check_count(reader, "alpha", alphas.size(), mesh.positions.size());
    for (const double alpha : alphas)
        mesh.alphas.push_back(static_cast<float>(alpha));
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
    return {
        list("P", Point, "Vertex positions."),
        renamed(list("triindices", Integer, "Vertices of the triangles, three each, from 0."),
                "indices"),
        list("quadindices", Integer, "Vertices of quadrilaterals, four each, from 0."),
        list("N", Normal, "Vertex normals, one for each position."),
        renamed(list("uv", Float, "Texture coordinates, a pair for each position."), "st"),
        list("C", Color, "Vertex colours, which hitpointcolor and hitpointgrey read."),
        list("alpha", Float, "Vertex opacities, which hitpointalpha reads."),
        {"gamma", Float, "1", "Exponent of the vertex colours.", 0},
        past("ntris", Integer, "Number of triangles; the list tells it."),
        past("nvertices", Integer, "Number of vertices; the list tells it."),
    };
}

TriangleMesh read_lists(const ParameterReader& reader) {
    TriangleMesh mesh;
    mesh.positions = read_vectors(reader, "P");
    if (!reader.given("P")) reader.fail("P", "a mesh needs vertex positions: \"point P\" [...]");
    if (mesh.positions.empty()) fail_empty(reader, "P", "the mesh has no vertices");
    check_vectors(mesh.positions, "vertex", {reader, "P", "\"P\""});
    const std::size_t vertex_count = mesh.positions.size();
    const std::string_view triangles = reader.spelling("triindices");
    append_faces(reader, triangles, 3, vertex_count, mesh.indices);
    append_faces(reader, "quadindices", 4, vertex_count, mesh.indices);
    if (!reader.given(triangles) && !reader.given("quadindices"))
        reader.fail(triangles, "a mesh needs triangles: \"integer triindices\" [...]");
    if (mesh.indices.empty()) fail_empty(reader, triangles, "the mesh has no triangles");
    if (reader.given("N")) mesh.normals = read_normals(reader, vertex_count);
    if (reader.given("uv"))
        mesh.uvs = read_coordinates(reader, reader.spelling("uv"), vertex_count);
    read_colors(reader, mesh);
    return mesh;
}

}  // namespace lxs
