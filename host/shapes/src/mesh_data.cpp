// Checks and completes mesh data.
#include "mesh_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "empty_shape.h"
#include "lxs/scene/on_all_threads.h"

namespace lxs {
namespace {

using Imath::V3d;

bool in_range(const Vec3& v) {
    // Negated comparisons catch NaN too.
    return !(!(std::abs(v.x) <= kLargestCoordinate) || !(std::abs(v.y) <= kLargestCoordinate) ||
             !(std::abs(v.z) <= kLargestCoordinate));
}

V3d cross_product(const std::vector<Vec3>& positions, const std::uint32_t* corner) {
    const V3d p(positions[corner[0]]);
    return (V3d(positions[corner[1]]) - p).cross(V3d(positions[corner[2]]) - p);
}

/// No area: exactly none, or no more than rounding makes of three points on a line.
bool is_degenerate(const std::vector<Vec3>& positions, const std::uint32_t* corner) {
    constexpr double kSmallestSine = 1e-12;
    const V3d p0(positions[corner[0]]), p1(positions[corner[1]]), p2(positions[corner[2]]);
    const double longest2 =
        std::max({(p1 - p0).length2(), (p2 - p0).length2(), (p2 - p1).length2()});
    return !(cross_product(positions, corner).length() > kSmallestSine * longest2);
}

void drop_degenerate(TriangleMesh& mesh, const ParameterReader& reader) {
    const std::size_t triangles = mesh.indices.size() / 3;
    const std::size_t first = first_where(triangles, [&](std::size_t i) {
        return is_degenerate(mesh.positions, &mesh.indices[3 * i]);
    });
    if (first == triangles && triangles > 0) return;
    std::size_t kept = 3 * first;
    for (std::size_t i = kept; i < mesh.indices.size(); i += 3) {
        if (is_degenerate(mesh.positions, &mesh.indices[i])) continue;
        std::copy_n(mesh.indices.begin() + static_cast<std::ptrdiff_t>(i), 3,
                    mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += 3;
    }
    const std::size_t dropped = (mesh.indices.size() - kept) / 3;
    mesh.indices.resize(kept);
    if (kept == 0) throw EmptyShape(reader.where(), "no triangle of the mesh has an area");
    if (dropped == 0) return;
    reader.diagnostics().warning(reader.where(), fmt::format("{} triangle{} without area left out",
                                                             dropped, dropped == 1 ? "" : "s"));
}

void transform_positions(TriangleMesh& mesh, const Matrix& to_world,
                         const ParameterReader& reader) {
    const auto moved = [&](std::size_t i) {
        V3d image;
        to_world.multVecMatrix(V3d(mesh.positions[i]), image);
        return image;
    };
    const std::size_t bad = first_where(mesh.positions.size(), [&](std::size_t i) {
        const Vec3 image(moved(i));
        if (!in_range(image)) return true;
        mesh.positions[i] = image;
        return false;
    });
    if (bad == mesh.positions.size()) return;
    const V3d image = moved(bad);
    throw InputError(reader.where(),
                     fmt::format("the current transform moves vertex {} out of range ({}, {}, {}); "
                                 "at most {:g}",
                                 bad, image.x, image.y, image.z, kLargestCoordinate));
}

void transform_normals(TriangleMesh& mesh, const Matrix& to_world) {
    // Cofactors are the inverse transpose times the determinant: they need no inverse.
    V3d axes[3];
    for (int i = 0; i < 3; ++i)
        axes[i] = V3d(to_world[i][0], to_world[i][1], to_world[i][2]);
    V3d cofactors[3];
    for (int i = 0; i < 3; ++i)
        cofactors[i] = axes[(i + 1) % 3].cross(axes[(i + 2) % 3]);
    const double sign = axes[0].dot(cofactors[0]) < 0 ? -1 : 1;
    const auto turned = [&](std::size_t i) {
        const Vec3 n = mesh.normals[i];
        return (cofactors[0] * n.x + cofactors[1] * n.y + cofactors[2] * n.z) * sign;
    };
    const bool has_zero = first_where(mesh.normals.size(), [&](std::size_t i) {
                              return !(turned(i).length() > 0);
                          }) < mesh.normals.size();
    const std::vector<Vec3> geometric =
        has_zero ? smooth_normals(mesh.positions, mesh.indices) : std::vector<Vec3>();
    in_pieces(mesh.normals.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const V3d image = turned(i);
            const double length = image.length();
            mesh.normals[i] = length > 0 ? Vec3(image / length) : geometric[i];
        }
    });
}

}  // namespace

void check_vectors(const std::vector<Vec3>& vectors, std::string_view noun,
                   const MeshSource& source) {
    const std::size_t bad =
        first_where(vectors.size(), [&](std::size_t i) { return !in_range(vectors[i]); });
    if (bad == vectors.size()) return;
    const Vec3& v = vectors[bad];
    const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    source.reader.fail(
        source.parameter,
        fmt::format("{} {} of {} is {}: ({}, {}, {})", noun, bad, source.label,
                    finite ? fmt::format("beyond {:g}", kLargestCoordinate) : "not finite", v.x,
                    v.y, v.z));
}

void check_coordinates(const std::vector<Vec2>& uvs, const MeshSource& source) {
    const std::size_t bad = first_where(uvs.size(), [&](std::size_t i) {
        return !std::isfinite(uvs[i].x) || !std::isfinite(uvs[i].y);
    });
    if (bad == uvs.size()) return;
    source.reader.fail(source.parameter, fmt::format("pair {} of {} is not finite: ({}, {})", bad,
                                                     source.label, uvs[bad].x, uvs[bad].y));
}

TriangleMesh finish_mesh(TriangleMesh mesh, const Matrix& to_world, const ParameterReader& reader) {
    transform_positions(mesh, to_world, reader);
    drop_degenerate(mesh, reader);
    transform_normals(mesh, to_world);
    return mesh;
}

std::vector<ParameterDeclaration> compatibility_parameters() {
    using enum ParameterType;
    constexpr auto kInfinity = std::numeric_limits<double>::infinity();
    const auto past = [](std::string_view name, ParameterType type, std::string_view default_text,
                         std::string_view doc) {
        return ParameterDeclaration{name,      type, default_text, doc, -kInfinity,
                                    kInfinity, {},   false,        true};
    };
    return {
        {"name", String, "", "Name of the shape in messages."},
        {"discardmeshnormals", Bool, "false", "The mesh's own normals are left out."},
        past("generatetangents", Bool, "false", "Tangents for normal maps made from coordinates."),
        past("acceltype", String, "auto", "Acceleration structure; Embree's is used."),
        past("tritype", String, "auto", "Kind of triangle test; Embree's is used."),
        past("quadtype", String, "quadrilateral", "Kind of quadrilateral; two triangles are used."),
    };
}

}  // namespace lxs
