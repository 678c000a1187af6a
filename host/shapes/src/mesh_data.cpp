// Checks and completes mesh data.
#include "mesh_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "empty_shape.h"

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
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
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
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        V3d image;
        to_world.multVecMatrix(V3d(mesh.positions[i]), image);
        mesh.positions[i] = Vec3(image);
        if (!in_range(mesh.positions[i])) {
            throw InputError(reader.where(),
                             fmt::format("the current transform moves vertex {} out of range ({}, "
                                         "{}, {}); at most {:g}",
                                         i, image.x, image.y, image.z, kLargestCoordinate));
        }
    }
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
    std::vector<Vec3> geometric;  // made when a normal turns out to be zero
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Vec3 n = mesh.normals[i];
        V3d image = (cofactors[0] * n.x + cofactors[1] * n.y + cofactors[2] * n.z) * sign;
        const double length = image.length();
        if (length > 0) {
            mesh.normals[i] = Vec3(image / length);
            continue;
        }
        if (geometric.empty()) geometric = smooth_normals(mesh.positions, mesh.indices);
        mesh.normals[i] = geometric[i];
    }
}

}  // namespace

void check_vectors(const std::vector<Vec3>& vectors, std::string_view noun,
                   const MeshSource& source) {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const Vec3& v = vectors[i];
        if (in_range(v)) continue;
        const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        source.reader.fail(
            source.parameter,
            fmt::format("{} {} of {} is {}: ({}, {}, {})", noun, i, source.label,
                        finite ? fmt::format("beyond {:g}", kLargestCoordinate) : "not finite", v.x,
                        v.y, v.z));
    }
}

void check_coordinates(const std::vector<Vec2>& uvs, const MeshSource& source) {
    for (std::size_t i = 0; i < uvs.size(); ++i) {
        if (std::isfinite(uvs[i].x) && std::isfinite(uvs[i].y)) continue;
        source.reader.fail(source.parameter, fmt::format("pair {} of {} is not finite: ({}, {})", i,
                                                         source.label, uvs[i].x, uvs[i].y));
    }
}

std::vector<Vec3> smooth_normals(const std::vector<Vec3>& positions,
                                 const std::vector<std::uint32_t>& indices) {
    std::vector<V3d> sums(positions.size(), V3d(0.0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const V3d normal = cross_product(positions, &indices[i]).normalized();
        for (std::size_t k = 0; k < 3; ++k)
            sums[indices[i + k]] += normal;
    }
    std::vector<Vec3> normals;
    normals.reserve(sums.size());
    for (const V3d& sum : sums) {
        const double length = sum.length();
        normals.push_back(length > 0 ? Vec3(sum / length) : Vec3(0, 0, 1));
    }
    return normals;
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
