// Area light of a triangle mesh: triangles chosen by area.
#include "mesh_light.h"

#include <cmath>

#include "warp.h"

namespace lxs {
namespace {

/// Most triangles of a mesh that one coordinate chooses between; of more both do, so that each has
/// bits left for the place in a triangle.
constexpr std::size_t kMostInARow = 1024;

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
    const std::size_t count = mesh.indices.size() / 3;
    triangles_.reserve(count);
    if (!mesh.uvs.empty()) uvs_.reserve(count);
    std::vector<double> areas;
    areas.reserve(count);
    double area = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* v = &mesh.indices[3 * i];
        Triangle& t = triangles_.emplace_back();
        t.p = world_position(mesh, v[0], to_world);
        t.e1 = world_position(mesh, v[1], to_world) - t.p;
        t.e2 = world_position(mesh, v[2], to_world) - t.p;
        t.error = position_error(t.p, t.e1, t.e2);
        const Imath::V3d cross = Imath::V3d(t.e1) % Imath::V3d(t.e2);
        const double length = cross.length();
        if (length > 0) t.n = Vec3(cross * ((flip ? -1 : 1) / length));
        areas.push_back(length > 0 ? length / 2 : 0);
        area += areas.back();
        if (!mesh.uvs.empty()) uvs_.push_back({mesh.uvs[v[0]], mesh.uvs[v[1]], mesh.uvs[v[2]]});
    }
    choose_by(areas, area);
    set_emission(emission, area);
}

void MeshLight::choose_by(const std::vector<double>& areas, double area) {
    if (!(area > 0) || !std::isfinite(area)) return;
    const std::size_t count = areas.size();
    const auto width =
        count <= kMostInARow
            ? count
            : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    std::vector<float> shares;
    shares.reserve(count);
    for (const double a : areas)
        shares.push_back(static_cast<float>(a / area));
    choice_ = CellChoice(width, (count + width - 1) / width, shares);
    for (std::size_t i = 0; i < count; ++i) {
        const double probability = double(choice_.probability(i / width, i % width));
        if (probability > 0) triangles_[i].density = static_cast<float>(probability / areas[i]);
    }
}

SurfacePoint MeshLight::sample_surface(const Vec2& u) const {
    if (!choice_.positive()) return {};
    // The place within the chosen triangle is uniform again: low discrepancy survives.
    const DrawnCell drawn = choice_.draw(u);
    const std::size_t i = drawn.row * choice_.width() + drawn.column;
    const Triangle& t = triangles_[i];
    const Vec2 b = uniform_triangle(drawn.share.x, drawn.share.y);
    SurfacePoint s;
    s.p = t.p + t.e1 * b.x + t.e2 * b.y;
    s.p_error = t.error;
    s.n = t.n;
    s.density = t.density;
    s.primitive = static_cast<std::uint32_t>(i);
    s.uv = Vec2(0.5f, 0.5f);  // as at hits of a mesh without texture coordinates
    if (!uvs_.empty()) {
        const TriangleUvs& uv = uvs_[i];
        s.uv = uv.a * (1.0f - b.x - b.y) + uv.b * b.x + uv.c * b.y;
    }
    return s;
}

bool MeshLight::surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const {
    if (primitive >= triangles_.size() || !(triangles_[primitive].density > 0)) return false;
    const Triangle& t = triangles_[primitive];
    return choice_.coordinates(primitive / choice_.width(), primitive % choice_.width(),
                               from_uniform_triangle(barycentric(t.e1, t.e2, p - t.p)), u);
}

}  // namespace lxs
