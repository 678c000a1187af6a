// Area lights of disks and of spheres that are cut, stretched or turned inside out: by area.
#pragma once

#include "surface_light.h"

namespace lxs {

using FlatOrRound = std::variant<Sphere, Disk>;

/// Affine image of a disk or sphere patch, sampled uniformly over the patch in its own space.
class QuadricLight final : public SurfaceLight {
  public:
    /// `shape_to_object` places the patch in its object, `to_world` the object.
    QuadricLight(const Primitive& primitive, const AreaEmission& emission, const FlatOrRound& patch,
                 const Matrix& shape_to_object, const Matrix& to_world);

  private:
    /// A point of the patch in its own space; `n` is its outward unit normal.
    struct LocalPoint {
        Vec3 p{0.0f}, n{0.0f};
        Vec2 uv{0.0f};
    };

    SurfacePoint sample_surface(const Vec2& u) const override;
    bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const override;
    float area_density(const Vec3& p, std::uint32_t primitive) const override;
    LocalPoint local_point(const Vec2& u) const;
    LocalPoint local_point(const Sphere& sphere, const Vec2& u) const;
    LocalPoint local_point(const Disk& disk, const Vec2& u) const;
    /// Inverse of the first coordinate of local_point for a point about on the patch.
    static float first_coordinate(const Sphere& sphere, const Vec3& p);
    static float first_coordinate(const Disk& disk, const Vec3& p);
    double local_area() const;
    /// Largest coordinate of the patch in its own space.
    float reach() const;
    double world_area() const;
    /// World area per local area where the local normal is `n`, and n's image (not unit).
    float stretch(const Vec3& n, Vec3& normal_image) const;

    FlatOrRound shape_;
    float phi_max_ = 0;  ///< radians
    Vec3 rows_[4];       ///< images of the local axes, and the translation
    Vec3 cofactors_[3];  ///< rows of det * inverse transpose
    Imath::M44f to_local_;
    bool flip_ = false;
    float local_density_ = 0;  ///< per unit of local area
    float error_ = 0;          ///< bound of the rounding error of any point
};

}  // namespace lxs
