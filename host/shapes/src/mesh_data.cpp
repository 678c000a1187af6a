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

bool is_finite(float v) {
    return std::isfinite(v);
}
bool is_finite(const Vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool in_range(const Vec3& v) {
    // Negated comparisons catch NaN too.
    return !(!(std::abs(v.x) <= kLargestCoordinate) || !(std::abs(v.y) <= kLargestCoordinate) ||
             !(std::abs(v.z) <= kLargestCoordinate));
}

/// What is wrong with a vector that isn't in_range().
std::string out_of_range(const Vec3& v) {
    return fmt::format("is {}: ({}, {}, {})",
                       is_finite(v) ? fmt::format("beyond {:g}", kLargestCoordinate) : "not finite",
                       v.x, v.y, v.z);
}

void report(const MeshSource& source, const std::string& fault, const std::string& instead) {
    source.reader.diagnostics().fallback(source.reader.where(source.parameter), fault, instead);
}

/// Replaces values that are not finite, value i by instead(i), with one message.
template <class T, class Instead>
void mend_values(std::vector<T>& values, const Instead& instead, std::string_view noun,
                 const std::string& instead_text, const MeshSource& source) {
    const std::size_t first =
        first_where(values.size(), [&](std::size_t i) { return !is_finite(values[i]); });
    if (first == values.size()) return;
    std::size_t count = 0;
    for (std::size_t i = first; i < values.size(); ++i) {
        if (is_finite(values[i])) continue;
        values[i] = instead(i);
        ++count;
    }
    const std::string others = count == 1 ? "is" : fmt::format("and {} more are", count - 1);
    report(source, fmt::format("{} {} of {} {} not finite", noun, first, source.label, others),
           instead_text);
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

void check_position(const Vec3& position, const MeshSource& source) {
    if (in_range(position)) return;
    source.reader.fail(source.parameter, source.label + " " + out_of_range(position));
}

void mend_positions(TriangleMesh& mesh, const MeshSource& source) {
    const auto is_bad = [&](std::size_t i) { return !in_range(mesh.positions[i]); };
    if (first_where(mesh.positions.size(), is_bad) == mesh.positions.size()) return;
    std::size_t kept = 0, first = mesh.positions.size();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corners = mesh.indices.begin() + static_cast<std::ptrdiff_t>(i);
        const auto bad = std::find_if(corners, corners + 3, is_bad);
        if (bad != corners + 3) {
            first = std::min<std::size_t>(first, *bad);
            continue;
        }
        std::copy_n(corners, 3, mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += 3;
    }
    if (first < mesh.positions.size()) {
        const std::string fault = fmt::format("vertex {} of {} {}", first, source.label,
                                              out_of_range(mesh.positions[first]));
        if (kept == 0) source.reader.fail(source.parameter, fault);
        const std::size_t dropped = (mesh.indices.size() - kept) / 3;
        report(source, fault,
               fmt::format("{} triangle{} with such a vertex {} left out", dropped,
                           dropped == 1 ? "" : "s", dropped == 1 ? "is" : "are"));
        mesh.indices.resize(kept);
    }
    // No triangle uses them any more, but transforms and boxes go over all vertices.
    const Vec3 anywhere = mesh.positions[mesh.indices.front()];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (is_bad(i)) mesh.positions[i] = anywhere;
    }
}

void mend_normals(TriangleMesh& mesh, const MeshSource& source) {
    const auto is_usable = [&](std::size_t i) {
        return is_finite(mesh.normals[i]) && mesh.normals[i] != Vec3(0.0f);
    };
    const std::size_t first =
        first_where(mesh.normals.size(), [&](std::size_t i) { return !is_usable(i); });
    if (first == mesh.normals.size()) return;
    const std::vector<Vec3> geometric = smooth_normals(mesh.positions, mesh.indices);
    mend_values(
        mesh.normals, [&](std::size_t i) { return geometric[i]; }, "normal",
        "the mean of the triangles there is used", source);
    for (std::size_t i = first; i < mesh.normals.size(); ++i) {
        if (!is_usable(i)) mesh.normals[i] = geometric[i];
    }
}

void mend_coordinates(TriangleMesh& mesh, const MeshSource& source) {
    mend_values(
        mesh.uvs, [](std::size_t) { return Vec2(0.0f); }, "pair", "0 0 is used", source);
}

void mend_colors(TriangleMesh& mesh, const MeshSource& source) {
    mend_values(
        mesh.colors, [](std::size_t) { return Rgb(1.0f); }, "colour", "white is used", source);
}

void mend_alphas(TriangleMesh& mesh, const MeshSource& source) {
    mend_values(
        mesh.alphas, [](std::size_t) { return 1.0f; }, "opacity", "1 is used", source);
}

void apply_gamma(std::vector<Rgb>& colors, float gamma) {
    if (gamma == 1) return;
    for (Rgb& color : colors) {
        for (int k = 0; k < 3; ++k)
            color[k] = std::pow(std::max(color[k], 0.0f), gamma);
    }
}

namespace {

/// Winds faces such that they look where the normals at their corners do.
void wind_by_normals(TriangleMesh& mesh) {
    if (mesh.normals.empty()) return;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        const Vec3 face =
            (mesh.positions[b] - mesh.positions[a]) % (mesh.positions[c] - mesh.positions[a]);
        if (face.dot(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

/// Gives each face another one behind it, turned over; `share` of the mesh's extent away.
void add_backs(TriangleMesh& mesh, float share) {
    Imath::Box3f box;
    for (const Vec3& p : mesh.positions)
        box.extendBy(p);
    const Vec3 size = mesh.positions.empty() ? Vec3(0.0f) : box.size();
    const float distance = share * std::max({size.x, size.y, size.z});
    const auto copy = [](auto& values, std::size_t from) {
        if (!values.empty())
            values.push_back(typename std::decay_t<decltype(values)>::value_type(values[from]));
    };
    const std::vector<std::uint32_t> fronts = mesh.indices;
    for (std::size_t i = 0; i + 2 < fronts.size(); i += 3) {
        const Vec3 &a = mesh.positions[fronts[i]], &b = mesh.positions[fronts[i + 1]],
                   &c = mesh.positions[fronts[i + 2]];
        const Vec3 away = ((b - a) % (c - a)).normalized() * distance;
        for (const std::size_t corner : {i, i + 2, i + 1}) {
            const std::size_t from = fronts[corner];
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(mesh.positions[from] - away);
            if (!mesh.normals.empty()) mesh.normals.push_back(-mesh.normals[from]);
            copy(mesh.uvs, from);
            copy(mesh.colors, from);
            copy(mesh.alphas, from);
        }
    }
}

}  // namespace

TriangleMesh finish_mesh(TriangleMesh mesh, const Matrix& to_world, const ParameterReader& reader) {
    if (reader.boolean("facesbynormals", false)) wind_by_normals(mesh);
    if (const double share = reader.number("backs", 0); share != 0)
        add_backs(mesh, static_cast<float>(share));
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
        {"facesbynormals", Bool, "false",
         "Faces look where the normals at their corners do, and are flat where there are none. Not "
         "LuxRender's."},
        {"backs", Float, "0",
         "Above 0: each face has another one behind it, turned over, so far away as a share of the "
         "mesh's extent; below 0: in front of it. Not LuxRender's.",
         -0.1, 0.1},
        past("generatetangents", Bool, "false", "Tangents for normal maps made from coordinates."),
        past("acceltype", String, "auto", "Acceleration structure; Embree's is used."),
        past("tritype", String, "auto", "Kind of triangle test; Embree's is used."),
        past("quadtype", String, "quadrilateral", "Kind of quadrilateral; two triangles are used."),
    };
}

}  // namespace lxs
