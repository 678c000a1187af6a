// Lights at infinity around one direction: a single direction, or a cone of constant radiance.
#pragma once

#include "environment_light.h"
#include "warp.h"

namespace lxs {

/// Parallel light (distant, theta 0).
class ParallelLight final : public EnvironmentLight {
  public:
    /// `wi` towards the light, `irradiance` on a surface facing it.
    ParallelLight(const LightPlacement& placement, const SceneSphere& sphere, const Vec3& wi,
                  const Rgb& irradiance);
    bool at_infinity() const override { return false; }
    bool is_delta() const override { return true; }

  private:
    bool sample_direction(const Vec2& u, SkyDirection& direction) const override;
    float direction_density(const Vec3& /*wi*/) const override { return 0; }
    bool direction_coordinates(const Vec3& /*wi*/, Vec2& /*u*/) const override { return true; }

    Vec3 wi_;
    Rgb irradiance_;
};

/// Disk in the sky (sun, distant with theta > 0).
class ConeLight final : public EnvironmentLight {
  public:
    /// `sin_max` is the sine of the cone's half angle, at most 90 degrees.
    ConeLight(const LightPlacement& placement, std::string_view kind, const SceneSphere& sphere,
              const Vec3& axis, float sin_max, const Rgb& radiance);
    Rgb escaped(const Vec3& direction) const override {
        return inside(direction) ? radiance_ : Rgb(0.0f);
    }
    /// Solid angle in steradians of a cone whose half angle has the sine `sin_max`.
    static float solid_angle(float sin_max);

  private:
    bool sample_direction(const Vec2& u, SkyDirection& direction) const override;
    float direction_density(const Vec3& wi) const override {
        return inside(wi) ? 1.0f / (2 * kPi * extent_) : 0.0f;
    }
    bool direction_coordinates(const Vec3& wi, Vec2& u) const override;
    bool inside(const Vec3& w) const { return (w - frame_.n).length2() <= 2 * extent_; }

    Frame frame_;
    float extent_;  ///< 1 - cosine of the half angle
    Rgb radiance_;
};

}  // namespace lxs
