// Reads vertices and faces of PLY files; other elements are passed over.
#include "ply_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lxs/scene/on_all_threads.h"
#include "ply_rows.h"
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
    std::array<int, 3> position, normal;
    std::array<int, 2> uv;
    std::array<int, 3> color;
    int alpha;
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

/// Writes vertices of a mesh from rows of numbers.
class VertexWriter {
  public:
    /// Throws std::runtime_error for vertices without a position.
    VertexWriter(const PlyElement& element, TriangleMesh& mesh)
        : columns_(element),
          mesh_(mesh),
          has_normals_(all(columns_.normal)),
          has_uvs_(all(columns_.uv)),
          has_colors_(all(columns_.color)),
          has_alphas_(columns_.alpha >= 0),
          color_unit_(1 / color_scale(element, columns_.color[0])),
          alpha_unit_(1 / color_scale(element, columns_.alpha)) {
        if (!all(columns_.position)) throw std::runtime_error("its vertices have no x, y and z");
    }

    /// And for one more position, which the kernel may read.
    void reserve(std::size_t count) {
        mesh_.positions.reserve(count + 1);
        if (has_normals_) mesh_.normals.reserve(count);
        if (has_uvs_) mesh_.uvs.reserve(count);
    }
    void resize(std::size_t count) {
        mesh_.positions.resize(count);
        if (has_normals_) mesh_.normals.resize(count);
        if (has_uvs_) mesh_.uvs.resize(count);
        if (has_colors_) mesh_.colors.resize(count);
        if (has_alphas_) mesh_.alphas.resize(count);
    }
    /// at(k) is column k of the vertex.
    template <class At>
    void write(std::size_t i, const At& at) {
        const auto vector = [&](const std::array<int, 3>& column, double unit) {
            return Vec3(static_cast<float>(at(column[0]) * unit),
                        static_cast<float>(at(column[1]) * unit),
                        static_cast<float>(at(column[2]) * unit));
        };
        mesh_.positions[i] = vector(columns_.position, 1);
        if (has_normals_) mesh_.normals[i] = vector(columns_.normal, 1);
        if (has_uvs_)
            mesh_.uvs[i] = Vec2(static_cast<float>(at(columns_.uv[0])),
                                static_cast<float>(at(columns_.uv[1])));
        if (has_colors_) mesh_.colors[i] = vector(columns_.color, color_unit_);
        if (has_alphas_) mesh_.alphas[i] = static_cast<float>(at(columns_.alpha) * alpha_unit_);
    }

  private:
    template <std::size_t kCount>
    static bool all(const std::array<int, kCount>& columns) {
        return std::ranges::all_of(columns, [](int column) { return column >= 0; });
    }

    const VertexColumns columns_;
    TriangleMesh& mesh_;
    const bool has_normals_, has_uvs_, has_colors_, has_alphas_;
    const double color_unit_, alpha_unit_;
};

/// One after another, where rows differ in length.
void read_vertices_in_turn(const PlyElement& element, std::size_t room, PlyValues& values,
                           VertexWriter& writer) {
    writer.reserve(room);
    std::vector<double> row(element.properties.size());
    for (std::size_t i = 0; i < element.count; ++i) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (property.is_list) {
                skip_list(property, values);
            } else {
                row[k] = values.next(property.type);
            }
        }
        writer.resize(i + 1);
        writer.write(i, [&](int column) { return row[static_cast<std::size_t>(column)]; });
    }
}

void read_vertices(const PlyElement& element, std::size_t room, PlyValues& values,
                   TriangleMesh& mesh) {
    VertexWriter writer(element, mesh);
    const std::optional<PlyRows> rows = equal_rows(element, values, 0);
    if (!rows) return read_vertices_in_turn(element, room, values, writer);
    writer.reserve(element.count);
    writer.resize(element.count);
    in_pieces(element.count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            writer.write(
                i, [&](int column) { return rows->value(i, static_cast<std::size_t>(column)); });
        }
    });
    values.take(rows->bytes());
}

[[noreturn]] void fail_vertex(std::size_t face, double index, double vertex_count) {
    throw std::runtime_error(
        fmt::format("face {} names vertex {}, but there are {} vertices, numbered from 0", face,
                    index, vertex_count));
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
        if (!(index >= 0 && index < vertex_count)) fail_vertex(face, index, vertex_count);
        const auto corner = static_cast<std::uint32_t>(index);
        if (k == 0) first = corner;
        if (k >= 2) indices.insert(indices.end(), {first, last, corner});
        last = corner;
    }
}

/// Faces that are all triangles, in rows of one length; false if they are not. `corners` is the
/// property that lists them.
bool read_triangles(const PlyElement& element, std::size_t corners, double vertex_count,
                    PlyValues& values, std::vector<std::uint32_t>& indices) {
    constexpr std::size_t kCorners = 3;
    const std::optional<PlyRows> rows = equal_rows(element, values, kCorners);
    if (!rows) return false;
    const auto is_other = [&](std::size_t i) { return rows->value(i, corners) != kCorners; };
    if (first_where(element.count, is_other) < element.count) return false;
    const std::size_t begin = indices.size();
    indices.resize(begin + kCorners * element.count);
    const std::size_t bad = first_where(element.count, [&](std::size_t i) {
        for (std::size_t k = 0; k < kCorners; ++k) {
            const double index = rows->list_value(i, corners, k);
            if (!(index >= 0 && index < vertex_count)) return true;
            indices[begin + kCorners * i + k] = static_cast<std::uint32_t>(index);
        }
        return false;
    });
    for (std::size_t k = 0; bad < element.count; ++k) {
        const double index = rows->list_value(bad, corners, k);
        if (!(index >= 0 && index < vertex_count)) fail_vertex(bad, index, vertex_count);
    }
    values.take(rows->bytes());
    return true;
}

void read_faces(const PlyElement& element, std::size_t room, PlyValues& values,
                TriangleMesh& mesh) {
    const int corners = element.find({"vertex_indices", "vertex_index"});
    if (corners < 0 || !element.properties[static_cast<std::size_t>(corners)].is_list)
        throw std::runtime_error("its faces have no list of vertex indices");
    const auto vertex_count = static_cast<double>(mesh.positions.size());
    if (read_triangles(element, static_cast<std::size_t>(corners), vertex_count, values,
                       mesh.indices))
        return;
    mesh.indices.reserve(3 * room);
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
