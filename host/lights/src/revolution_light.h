// Area lights of cylinders, cones, hyperboloids, paraboloids and tori.
#pragma once

#include "lxs/scene/surface_of_revolution.h"
#include "surface_light.h"

namespace lxs {

/// Affine image of a surface of revolution. Points are drawn by azimuth and by position along the
/// profile (SurfaceOfRevolution::v_of); their density per area is exact, and uniform for cylinders,
/// cones and paraboloids under similarities.
class RevolutionLight final : public SurfaceLight {
  public:
    RevolutionLight(const Primitive& primitive, const AreaEmission& emission,
                    const Quadric& quadric, const SurfaceOfRevolution& shape,
                    const Matrix& to_world);

  private:
    SurfacePoint sample_surface(const Vec2& u) const override;
    bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const override;
    float area_density(const Vec3& p, std::uint32_t primitive) const override;
    double world_area() const;
    /// World area per area of the shape's own space where its unit normal is `n`, and n's image
    /// (not unit).
    double stretch(const Imath::V3d& n, Imath::V3d& normal_image) const;
    /// Points per unit of world area at a point of the shape where dx/dv of v_of is `density`.
    float density_at(const RevolutionPoint& point, double density) const;

    SurfaceOfRevolution shape_;
    Matrix to_world_, to_local_;
    Imath::V3d cofactors_[3];  ///< rows of det * inverse transpose
    bool flip_ = false;
    float error_ = 0;  ///< bound of the rounding error of any point
};

}  // namespace lxs
