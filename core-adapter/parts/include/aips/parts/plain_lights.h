// Lights in closed form: surfaces that emit alike in all directions, and points.
#pragma once

#include <cmath>

#include "aips/adapter/scene.h"

namespace aips {

/// Two of the primary coordinates from `first` on, in single precision and below 1: fine enough for
/// scenes that are not vastly wider than what is seen of them.
Vec2 rounded_pair(const PrimaryPoint& u, std::size_t first);

/// A one-sided diffuse emitter of which uniform points can be drawn.
class DiffuseAreaLight : public Light {
  public:
    /// Radiance of its front, its area in square scene units. Photons start before the surface by
    /// `lift`, which has to cover the rounding of its coordinates; unless it is given, by a 10^-5th
    /// of the light's size, enough near the origin.
    DiffuseAreaLight(Rgb radiance, float area, std::uint32_t group, float lift = 0)
        : radiance_(radiance),
          area_(area),
          lift_(lift > 0 ? lift : 1e-5f * std::sqrt(area)),
          group_(group) {}

    std::uint32_t group() const override { return group_; }
    float power() const override;
    bool at_infinity() const override { return false; }
    Rgb escaped(Vec3) const override { return {}; }
    bool emit(const PrimaryPoint& u, Emission& emission) const override;
    bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const override;
    float pdf_direct(const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const override;
    bool emission_coordinates(const SurfacePoint& towards, const DirectSample& sample,
                              PrimaryPoint& u) const override;

  protected:
    /// A point on the surface and its front normal.
    struct SurfaceSample {
        Vec3 position, normal;
    };
    virtual SurfaceSample point(Vec2 u) const = 0;
    /// Inverse of point() for a position about on the surface; in [0,1)^2.
    virtual Vec2 coordinates(Vec3 position) const = 0;

  private:
    float density(Vec3 normal, Vec3 wi, float distance) const;

    Rgb radiance_;
    float area_, lift_;
    std::uint32_t group_;
};

/// Shines alike in all directions, with `intensity` watts per steradian.
class PointLight final : public Light {
  public:
    PointLight(Vec3 position, Rgb intensity, std::uint32_t group = 0)
        : position_(position), intensity_(intensity), group_(group) {}

    std::uint32_t group() const override { return group_; }
    float power() const override;
    bool at_infinity() const override { return false; }
    bool is_delta() const override { return true; }
    Rgb escaped(Vec3) const override { return {}; }
    bool emit(const PrimaryPoint& u, Emission& emission) const override;
    bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const override;
    float pdf_direct(const SurfacePoint&, Vec3, const SurfacePoint*) const override { return 0; }
    bool emission_coordinates(const SurfacePoint& towards, const DirectSample& sample,
                              PrimaryPoint& u) const override;

  private:
    Vec3 position_;
    Rgb intensity_;
    std::uint32_t group_;
};

}  // namespace aips
