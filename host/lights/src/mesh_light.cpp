// Area light of a triangle mesh: triangles chosen by area.
#include "mesh_light.h"

#include <algorithm>
#include <cmath>

#include "warp.h"

namespace lxs {
namespace {

Vec3 world_position(const TriangleMesh& mesh, std::uint32_t vertex, const Matrix& to_world) {
    Imath::V3d p;
    to_world.multVecMatrix(Imath::V3d(mesh.positions[vertex]), p);
    return Vec3(p);
}

/// Edges count in full: an intersection's rounding grows with the triangle, not with the point.
Vec3 position_error(const Vec3& p, const Vec3& e1, const Vec3& e2) {
    Vec3 error;
    for (int i = 0; i < 3; ++i)
        error[i] = rounding_bound(6) * (std::abs(p[i]) + std::abs(e1[i]) + std::abs(e2[i]));
    return error;
}

/// Barycentric coordinates (of the second and third vertex) of the foot of `offset`, which starts
/// at the first vertex, in the plane of the edges.
Vec2 barycentric(const Vec3& e1, const Vec3& e2, const Vec3& offset) {
    const Imath::V3d a(e1), b(e2), d(offset), n = a % b;
    const double n2 = n.length2();
    return Vec2(static_cast<float>(((d % b) ^ n) / n2), static_cast<float>(((a % d) ^ n) / n2));
}

}  // namespace

MeshLight::MeshLight(const Primitive& primitive, const AreaEmission& emission,
                     const TriangleMesh& mesh, const Matrix& to_world)
    : SurfaceLight(primitive, emission, to_world) {
    // The cross product of mirrored vertices points to the other side of the surface.
    const bool flip = primitive.reverse_orientation != (to_world.determinant() < 0);
    std::vector<double> cumulative;
    double area = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* v = &mesh.indices[i];
        const Vec3 p = world_position(mesh, v[0], to_world);
        const Vec3 e1 = world_position(mesh, v[1], to_world) - p;
        const Vec3 e2 = world_position(mesh, v[2], to_world) - p;
        const Imath::V3d cross = Imath::V3d(e1) % Imath::V3d(e2);
        const double length = cross.length();
        if (!(length > 0)) continue;
        area += length / 2;
        cumulative.push_back(area);
        triangles_.push_back({p, e1, e2, Vec3(cross * ((flip ? -1 : 1) / length)),
                              position_error(p, e1, e2), static_cast<std::uint32_t>(i / 3)});
        if (!mesh.uvs.empty()) uvs_.push_back({mesh.uvs[v[0]], mesh.uvs[v[1]], mesh.uvs[v[2]]});
    }
    for (const double sum : cumulative)
        cdf_.push_back(static_cast<float>(sum / area));
    density_ = area > 0 ? static_cast<float>(1 / area) : 0;
    set_emission(emission, area);
}

SurfacePoint MeshLight::sample_surface(const Vec2& u) const {
    if (triangles_.empty()) return {};
    std::size_t i = 0;
    float first = u.x;
    if (cdf_.size() > 1) {
        // The share of u.x within the chosen triangle is uniform again: low discrepancy survives.
        i = static_cast<std::size_t>(std::upper_bound(cdf_.begin(), cdf_.end() - 1, u.x) -
                                     cdf_.begin());
        const float below = i > 0 ? cdf_[i - 1] : 0.0f;
        first = std::clamp((u.x - below) / (cdf_[i] - below), 0.0f, 1.0f);
    }
    const Triangle& t = triangles_[i];
    const Vec2 b = uniform_triangle(first, u.y);
    SurfacePoint s;
    s.p = t.p + t.e1 * b.x + t.e2 * b.y;
    s.p_error = t.error;
    s.n = t.n;
    s.density = density_;
    s.primitive = t.primitive;
    s.uv = Vec2(0.5f, 0.5f);  // as at hits of a mesh without texture coordinates
    if (!uvs_.empty()) {
        const TriangleUvs& uv = uvs_[i];
        s.uv = uv.a * (1.0f - b.x - b.y) + uv.b * b.x + uv.c * b.y;
    }
    return s;
}

bool MeshLight::surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const {
    const auto found = std::lower_bound(
        triangles_.begin(), triangles_.end(), primitive,
        [](const Triangle& t, std::uint32_t index) { return t.primitive < index; });
    if (found == triangles_.end() || found->primitive != primitive) return false;
    u = from_uniform_triangle(barycentric(found->e1, found->e2, p - found->p));
    if (cdf_.size() == 1) return true;
    const auto i = static_cast<std::size_t>(found - triangles_.begin());
    const float below = i > 0 ? cdf_[i - 1] : 0.0f;
    if (!(cdf_[i] > below)) return false;  // too small a share of the mesh to be drawn
    u.x = within_interval(below, cdf_[i], u.x);
    return true;
}

}  // namespace lxs
