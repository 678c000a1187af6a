// Area lights of disks and of spheres that are cut, stretched or turned inside out: by area.
#include "quadric_light.h"

#include <algorithm>
#include <cmath>

#include "warp.h"

namespace lxs {

QuadricLight::QuadricLight(const Primitive& primitive, const AreaEmission& emission,
                           const FlatOrRound& patch, const Matrix& shape_to_object,
                           const Matrix& to_world)
    : SurfaceLight(primitive, emission, to_world), shape_(patch) {
    const float degrees = std::visit([](const auto& s) { return s.phi_max; }, shape_);
    phi_max_ = std::clamp(degrees, 0.0f, 360.0f) * (kPi / 180.0f);
    const Matrix matrix = shape_to_object * to_world;
    for (int i = 0; i < 4; ++i)
        rows_[i] = Vec3(Imath::V3d(matrix[i][0], matrix[i][1], matrix[i][2]));
    for (int i = 0; i < 3; ++i)
        cofactors_[i] = rows_[(i + 1) % 3] % rows_[(i + 2) % 3];
    // Cofactors turn with the sign of the determinant, outward normals don't.
    const bool mirrored = matrix.determinant() < 0;
    const bool reversed = primitive.reverse_orientation != (shape_to_object.determinant() < 0);
    flip_ = reversed != mirrored;
    to_local_ = Imath::M44f(matrix.inverse());
    error_ =
        rounding_bound(16) *
        (rows_[3].length() + reach() * (rows_[0].length() + rows_[1].length() + rows_[2].length()));
    const double local = local_area();
    local_density_ = local > 0 ? static_cast<float>(1 / local) : 0;
    set_emission(emission, world_area());
}

QuadricLight::LocalPoint QuadricLight::local_point(const Sphere& sphere, const Vec2& u) const {
    const float low = std::max(std::min(sphere.z_min, sphere.z_max), -sphere.radius);
    const float high = std::min(std::max(sphere.z_min, sphere.z_max), sphere.radius);
    const float z = low + u.x * (high - low);
    const float phi = u.y * phi_max_;
    const float rho = std::sqrt(std::max(0.0f, sphere.radius * sphere.radius - z * z));
    const auto polar = [&](float height) {
        return std::acos(std::clamp(height / sphere.radius, -1.0f, 1.0f));
    };
    LocalPoint s;
    s.p = Vec3(rho * std::cos(phi), rho * std::sin(phi), z);
    s.n = s.p / sphere.radius;
    if (!has_constant_emission())
        s.uv = Vec2(u.y, (polar(z) - polar(low)) / (polar(high) - polar(low)));
    return s;
}

QuadricLight::LocalPoint QuadricLight::local_point(const Disk& disk, const Vec2& u) const {
    const float inner2 = disk.inner_radius * disk.inner_radius;
    const float r = std::sqrt(inner2 + u.x * (disk.radius * disk.radius - inner2));
    const float phi = u.y * phi_max_;
    const float ring = disk.radius - disk.inner_radius;
    return {Vec3(r * std::cos(phi), r * std::sin(phi), disk.height), Vec3(0, 0, 1),
            Vec2(u.y, ring > 0 ? 1.0f - (r - disk.inner_radius) / ring : 0.0f)};
}

QuadricLight::LocalPoint QuadricLight::local_point(const Vec2& u) const {
    return std::visit([&](const auto& shape) { return local_point(shape, u); }, shape_);
}

float QuadricLight::reach() const {
    if (const Disk* disk = std::get_if<Disk>(&shape_))
        return std::max(std::abs(disk->radius), std::abs(disk->height));
    return std::abs(std::get<Sphere>(shape_).radius);
}

double QuadricLight::local_area() const {
    if (const Disk* disk = std::get_if<Disk>(&shape_)) {
        return 0.5 * phi_max_ *
               std::abs(double(disk->radius) * disk->radius -
                        double(disk->inner_radius) * disk->inner_radius);
    }
    const Sphere& sphere = std::get<Sphere>(shape_);
    const float low = std::max(std::min(sphere.z_min, sphere.z_max), -sphere.radius);
    const float high = std::min(std::max(sphere.z_min, sphere.z_max), sphere.radius);
    return double(phi_max_) * sphere.radius * std::max(0.0f, high - low);
}

double QuadricLight::world_area() const {
    constexpr std::size_t kGrid = 64;  // exact for disks and similarities, 1e-4 for mild ellipsoids
    double sum = 0;
    for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
        Vec3 unused;
        sum += stretch(local_point(grid_center(i, kGrid)).n, unused);
    }
    return local_area() * sum / (kGrid * kGrid);
}

float QuadricLight::stretch(const Vec3& n, Vec3& normal_image) const {
    normal_image = cofactors_[0] * n.x + cofactors_[1] * n.y + cofactors_[2] * n.z;
    return normal_image.length();
}

SurfacePoint QuadricLight::sample_surface(const Vec2& u) const {
    const LocalPoint local = local_point(u);
    SurfacePoint s;
    s.p = rows_[3] + rows_[0] * local.p.x + rows_[1] * local.p.y + rows_[2] * local.p.z;
    s.p_error = Vec3(error_);
    Vec3 normal;
    const float factor = stretch(local.n, normal);
    if (!(factor > 0)) return {};
    s.n = normal / (flip_ ? -factor : factor);
    s.uv = local.uv;
    s.density = local_density_ / factor;
    return s;
}

float QuadricLight::first_coordinate(const Sphere& sphere, const Vec3& p) {
    const float low = std::max(std::min(sphere.z_min, sphere.z_max), -sphere.radius);
    const float high = std::min(std::max(sphere.z_min, sphere.z_max), sphere.radius);
    return clamp_to_unit((p.normalized().z * sphere.radius - low) / (high - low));
}

float QuadricLight::first_coordinate(const Disk& disk, const Vec3& p) {
    const float inner2 = disk.inner_radius * disk.inner_radius;
    return clamp_to_unit((p.x * p.x + p.y * p.y - inner2) / (disk.radius * disk.radius - inner2));
}

bool QuadricLight::surface_coordinates(const Vec3& p, std::uint32_t /*primitive*/, Vec2& u) const {
    Vec3 local;
    to_local_.multDirMatrix(p - rows_[3], local);
    const float phi = 2 * kPi * turn_about_z(local.x, local.y);
    // A point that rounding put before the patch's first meridian goes back to it.
    const bool before = 2 * kPi - phi < phi - phi_max_;
    u.x = std::visit([&](const auto& shape) { return first_coordinate(shape, local); }, shape_);
    u.y = before ? 0.0f : clamp_to_unit(phi / phi_max_);
    return true;
}

float QuadricLight::area_density(const Vec3& p, std::uint32_t /*primitive*/) const {
    Vec3 n(0, 0, 1);
    if (std::holds_alternative<Sphere>(shape_)) {
        to_local_.multVecMatrix(p, n);
        n.normalize();
    }
    Vec3 unused;
    const float factor = stretch(n, unused);
    return factor > 0 ? local_density_ / factor : 0;
}

}  // namespace lxs
