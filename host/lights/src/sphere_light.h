// Area light of a whole sphere seen from outside: samples the cone that it subtends.
#pragma once

#include "surface_light.h"

namespace lxs {

/// Full sphere under a similarity transform, emitting outwards.
class SphereLight final : public SurfaceLight {
  public:
    /// `to_world` maps the unit sphere; its scale is the world radius. `object_to_world` places the
    /// object that the primitive belongs to.
    SphereLight(const Primitive& primitive, const AreaEmission& emission, const Matrix& to_world,
                const Matrix& object_to_world);

    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                     const Vec3& light_n, std::uint32_t primitive) const override;

  private:
    SurfacePoint sample_surface(const Vec2& u) const override;
    bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const override;
    float area_density(const Vec3& /*p*/, std::uint32_t /*primitive*/) const override {
        return density_;
    }
    SurfacePoint point_at(const Vec3& n) const;
    /// 1 - cosine of the half angle of the cone around `distance2` = squared distance of the
    /// centre; 0 inside of the sphere.
    float cone(float distance2) const;

    Vec3 center_{0.0f};
    float radius_ = 1;
    Vec3 error_{0.0f};  ///< of points on the surface, SurfacePoint::p_error
    Vec3 x_, y_, z_;    ///< unit axes of the sphere's own space, for texture coordinates
    float density_ = 0;
};

}  // namespace lxs
