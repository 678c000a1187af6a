// Base of area lights: emission and direct sampling by area, given points on the surface.
#pragma once

#include <cstdint>
#include <optional>

#include "emitted_radiance.h"
#include "lxs/lights/lights.h"
#include "surface_profile.h"

namespace lxs {

/// A point drawn on an emitting surface, world space.
struct SurfacePoint {
    Vec3 p{0.0f};
    Vec3 p_error{0.0f};  ///< bound of p's rounding error per coordinate
    Vec3 n{0.0f};        ///< unit, the side that emits
    Vec2 uv{0.0f};
    float density = 0;            ///< per unit of area; 0 means nothing was drawn
    std::uint32_t primitive = 0;  ///< index of the mesh's triangle
};

/// DirectSample::segment_end for a point met along the unit vector `wi` after `distance`.
Vec3 segment_end(const SurfacePoint& s, const Vec3& wi, float distance);

/// One-sided emitter, diffuse or with a profile of intensities. Derived classes call `set_emission`
/// once their area is known.
class SurfaceLight : public AreaLight {
  public:
    std::string_view kind() const override { return "area"; }
    float power() const override { return power_; }
    bool has_area() const override { return has_area_; }

    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                     const Vec3& light_n, std::uint32_t primitive) const override;
    bool emission_coordinates(const Vec3& p, const DirectSample& sample,
                              PrimaryPoint& u) const override;
    Rgb radiance(const Vec3& p, const Vec3& n, const Vec2& uv, const Vec3& wo) const override;
    CurvePointer spectrum() const override { return radiance_.spectrum(); }
    RefusedValues& refused_values() const override { return radiance_.refused_values(); }

  protected:
    /// `object_to_world` places the object that the primitive belongs to.
    SurfaceLight(const Primitive& primitive, const AreaEmission& emission,
                 const Matrix& object_to_world);

    /// Draws a point of the surface.
    virtual SurfacePoint sample_surface(const Vec2& u) const = 0;
    /// Inverse of sample_surface for a point about on the surface, on `primitive`; in [0, 1)^2.
    virtual bool surface_coordinates(const Vec3& p, std::uint32_t primitive, Vec2& u) const = 0;
    /// Density per unit of area with which sample_surface draws the point `p` of `primitive`.
    virtual float area_density(const Vec3& p, std::uint32_t primitive) const = 0;

    /// Sets gain, flux and power() for a surface of `area`; all are 0 if that is zero or not
    /// finite.
    void set_emission(const AreaEmission& emission, double area);
    bool has_constant_emission() const { return radiance_.is_constant(); }
    /// Radiance towards the unit vector `wo`, in front of the surface.
    Rgb emitted(const SurfacePoint& s, const Vec3& wo) const {
        return shaped(radiance_.at(s.p, s.n, s.uv), s.n, wo);
    }

  private:
    /// `radiance` as the profile sends it along `wo`, if there is one.
    Rgb shaped(const Rgb& radiance, const Vec3& n, const Vec3& wo) const {
        return profile_ ? radiance * profile_->radiance(n, wo) : radiance;
    }
    /// Mean over the surface of what the radiance sends into all directions, relative to a diffuse
    /// surface of luminance 1.
    float mean_luminance(double area) const;
    /// Direction and power of a photon that leaves `s`; false if none does.
    bool emit(const SurfacePoint& s, const Vec2& u, Vec3& direction, Rgb& power) const;

    EmittedRadiance radiance_;
    std::optional<SurfaceProfile> profile_;  ///< none: diffuse
    float power_ = 0;
    bool has_area_ = false;
};

}  // namespace lxs
