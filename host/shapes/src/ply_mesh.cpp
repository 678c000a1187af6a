// Reads vertices and faces of PLY files; other elements are passed over.
#include "ply_mesh.h"

#include <fmt/format.h>

#include <cmath>

#include "ply_values.h"

namespace lxs {
namespace {

/// Columns of what is used of a vertex; -1 where the file has none.
struct VertexColumns {
    explicit VertexColumns(const PlyElement& e)
        : position{e.find({"x"}), e.find({"y"}), e.find({"z"})},
          normal{e.find({"nx"}), e.find({"ny"}), e.find({"nz"})},
          uv{e.find({"s", "u", "texture_u"}), e.find({"t", "v", "texture_v"})},
          color{e.find({"red", "r"}), e.find({"green", "g"}), e.find({"blue", "b"})},
          alpha(e.find({"alpha", "a"})) {}
    int position[3], normal[3], uv[2], color[3], alpha;
};

/// What a colour of this type is divided by.
double color_scale(const PlyElement& vertices, int column) {
    if (column < 0) return 1;
    switch (vertices.properties[static_cast<std::size_t>(column)].type) {
        case PlyType::UInt8:
            return 255;
        case PlyType::UInt16:
            return 65535;
        default:
            return 1;
    }
}

void skip_list(const PlyProperty& property, PlyValues& values) {
    const double count = values.next(property.count_type);
    for (double i = 0; i < count; ++i)
        values.next(property.type);
}

/// Room for `count` more, but not for more than a damaged header could make plausible.
std::size_t plausible(std::size_t count, std::string_view file) {
    return std::min(count, file.size());
}

void read_vertices(const PlyElement& element, std::size_t room, PlyValues& values,
                   TriangleMesh& mesh) {
    const VertexColumns columns(element);
    if (columns.position[0] < 0 || columns.position[1] < 0 || columns.position[2] < 0)
        throw std::runtime_error("its vertices have no x, y and z");
    const bool has_normals =
        columns.normal[0] >= 0 && columns.normal[1] >= 0 && columns.normal[2] >= 0;
    const bool has_uvs = columns.uv[0] >= 0 && columns.uv[1] >= 0;
    const bool has_colors = columns.color[0] >= 0 && columns.color[1] >= 0 && columns.color[2] >= 0;
    const bool has_alphas = columns.alpha >= 0;
    const double color_unit = 1 / color_scale(element, columns.color[0]);
    const double alpha_unit = 1 / color_scale(element, columns.alpha);
    mesh.positions.reserve(room + 1);
    if (has_normals) mesh.normals.reserve(room);
    if (has_uvs) mesh.uvs.reserve(room);

    std::vector<double> row(element.properties.size());
    const auto at = [&](int column) { return row[static_cast<std::size_t>(column)]; };
    const auto vector = [&](const int* column, double unit) {
        return Vec3(static_cast<float>(at(column[0]) * unit),
                    static_cast<float>(at(column[1]) * unit),
                    static_cast<float>(at(column[2]) * unit));
    };
    for (std::size_t i = 0; i < element.count; ++i) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (property.is_list) {
                skip_list(property, values);
            } else {
                row[k] = values.next(property.type);
            }
        }
        mesh.positions.push_back(vector(columns.position, 1));
        if (has_normals) mesh.normals.push_back(vector(columns.normal, 1));
        if (has_uvs) {
            mesh.uvs.emplace_back(static_cast<float>(at(columns.uv[0])),
                                  static_cast<float>(at(columns.uv[1])));
        }
        if (has_colors) mesh.colors.push_back(vector(columns.color, color_unit));
        if (has_alphas) mesh.alphas.push_back(static_cast<float>(at(columns.alpha) * alpha_unit));
    }
}

/// One face's corners, cut into triangles (0, k, k + 1).
void read_corners(const PlyProperty& property, std::size_t face, double vertex_count,
                  PlyValues& values, std::vector<std::uint32_t>& indices) {
    const double corners = values.next(property.count_type);
    if (!(corners >= 3))
        throw std::runtime_error(fmt::format("face {} has {} corners", face, corners));
    std::uint32_t first = 0, last = 0;
    for (double k = 0; k < corners; ++k) {
        const double index = values.next(property.type);
        if (!(index >= 0 && index < vertex_count)) {
            throw std::runtime_error(
                fmt::format("face {} names vertex {}, but there are {} "
                            "vertices, numbered from 0",
                            face, index, vertex_count));
        }
        const auto corner = static_cast<std::uint32_t>(index);
        if (k == 0) first = corner;
        if (k >= 2) indices.insert(indices.end(), {first, last, corner});
        last = corner;
    }
}

void read_faces(const PlyElement& element, std::size_t room, PlyValues& values,
                TriangleMesh& mesh) {
    const int corners = element.find({"vertex_indices", "vertex_index"});
    if (corners < 0 || !element.properties[static_cast<std::size_t>(corners)].is_list)
        throw std::runtime_error("its faces have no list of vertex indices");
    mesh.indices.reserve(3 * room);
    const auto vertex_count = static_cast<double>(mesh.positions.size());
    for (std::size_t i = 0; i < element.count; ++i) {
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (static_cast<int>(k) == corners) {
                read_corners(property, i, vertex_count, values, mesh.indices);
            } else if (property.is_list) {
                skip_list(property, values);
            } else {
                values.next(property.type);
            }
        }
    }
}

void skip_element(const PlyElement& element, PlyValues& values) {
    for (std::size_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) {
            if (property.is_list) {
                skip_list(property, values);
            } else {
                values.next(property.type);
            }
        }
    }
}

}  // namespace

TriangleMesh read_ply_mesh(std::string_view file) {
    const PlyHeader header = read_ply_header(file);
    PlyValues values(file.substr(header.size), header.format);
    TriangleMesh mesh;
    bool has_vertices = false;
    for (const PlyElement& element : header.elements) {
        has_vertices |= element.name == "vertex";
        if (element.properties.empty()) continue;
        const std::size_t room = plausible(element.count, file);
        if (element.name == "vertex") {
            if (!mesh.positions.empty()) throw std::runtime_error("it has two lists of vertices");
            read_vertices(element, room, values, mesh);
        } else if (element.name == "face") {
            read_faces(element, room, values, mesh);
        } else {
            skip_element(element, values);
        }
    }
    if (!has_vertices) throw std::runtime_error("it holds no mesh");
    return mesh;
}

}  // namespace lxs
