// Area lights of cylinders, cones, hyperboloids, paraboloids and tori.
#include "revolution_light.h"

#include <algorithm>
#include <cmath>

#include "warp.h"

namespace lxs {

using Imath::V2d;
using Imath::V3d;

RevolutionLight::RevolutionLight(const Primitive& primitive, const AreaEmission& emission,
                                 const Quadric& quadric, const SurfaceOfRevolution& shape,
                                 const Matrix& to_world)
    : SurfaceLight(primitive, emission, to_world),
      shape_(shape),
      to_world_(quadric.to_world * to_world),
      to_local_(to_world_.inverse()) {
    V3d rows[4];
    for (int i = 0; i < 4; ++i)
        rows[i] = V3d(to_world_[i][0], to_world_[i][1], to_world_[i][2]);
    for (int i = 0; i < 3; ++i)
        cofactors_[i] = rows[(i + 1) % 3] % rows[(i + 2) % 3];
    // Cofactors turn with the sign of the determinant, normals of shapes don't.
    const bool mirrored = to_world_.determinant() < 0;
    const bool reversed = primitive.reverse_orientation != (quadric.to_world.determinant() < 0);
    flip_ = reversed != mirrored;
    const double reach =
        std::max({shape_.reach(), std::abs(shape_.z_min()), std::abs(shape_.z_max())});
    error_ = rounding_bound(16) *
             static_cast<float>(rows[3].length() +
                                reach * (rows[0].length() + rows[1].length() + rows[2].length()));
    set_emission(emission, world_area());
}

double RevolutionLight::stretch(const V3d& n, V3d& normal_image) const {
    normal_image = cofactors_[0] * n.x + cofactors_[1] * n.y + cofactors_[2] * n.z;
    return normal_image.length();
}

float RevolutionLight::density_at(const RevolutionPoint& point, double density) const {
    V3d unused;
    const double area = point.area * stretch(point.normal, unused) * shape_.phi_max();
    const auto result = static_cast<float>(density / area);
    return std::isfinite(result) ? result : 0;
}

double RevolutionLight::world_area() const {
    // The midpoint rule converges at once over whole turns; along profiles of changing density it
    // errs by less than 1e-4.
    constexpr std::size_t kGrid = 128;
    double sum = 0;
    for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
        const Vec2 u = grid_center(i, kGrid);
        double density = 0;
        const double v = shape_.v_of(u.x, density);
        const RevolutionPoint point = shape_.at(u.y * shape_.phi_max(), v);
        V3d unused;
        sum += point.area * stretch(point.normal, unused) / density;
    }
    return sum * shape_.phi_max() / (kGrid * kGrid);
}

SurfacePoint RevolutionLight::sample_surface(const Vec2& u) const {
    double density = 0;
    const double v = shape_.v_of(u.x, density);
    const RevolutionPoint local = shape_.at(u.y * shape_.phi_max(), v);
    SurfacePoint s;
    s.density = density_at(local, density);
    V3d p, normal;
    to_world_.multVecMatrix(local.p, p);
    stretch(local.normal, normal);
    s.p = Vec3(p);
    s.p_error = Vec3(error_);
    s.n = Vec3(normal.normalized()) * (flip_ ? -1.0f : 1.0f);
    s.uv = Vec2(u.y, static_cast<float>(v));
    return s;
}

bool RevolutionLight::surface_coordinates(const Vec3& p, std::uint32_t /*primitive*/,
                                          Vec2& u) const {
    V3d local;
    to_local_.multVecMatrix(V3d(p), local);
    const V2d at = shape_.coordinates(local);
    double unused = 0;
    u.x = clamp_to_unit(static_cast<float>(shape_.x_of(std::clamp(at.y, 0.0, 1.0), unused)));
    // A point that rounding put before the patch's first meridian goes back to it.
    const bool before = 2 * double(kPi) - at.x < at.x - shape_.phi_max();
    u.y = before ? 0.0f : clamp_to_unit(static_cast<float>(at.x / shape_.phi_max()));
    return true;
}

float RevolutionLight::area_density(const Vec3& p, std::uint32_t /*primitive*/) const {
    V3d local;
    to_local_.multVecMatrix(V3d(p), local);
    const V2d at = shape_.coordinates(local);
    const double v = std::clamp(at.y, 0.0, 1.0);
    double density = 0;
    shape_.x_of(v, density);
    return density_at(shape_.at(at.x, v), density);
}

}  // namespace lxs
