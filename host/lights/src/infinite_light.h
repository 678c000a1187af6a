// Light from all directions: constant, or an image sampled by importance.
#pragma once

#include "environment_light.h"
#include "latlong_map.h"
#include "rotation.h"

namespace lxs {

/// The same radiance from everywhere.
class ConstantEnvironment final : public EnvironmentLight {
  public:
    ConstantEnvironment(const LightPlacement& placement, const SceneSphere& sphere,
                        const Rgb& radiance);
    Rgb escaped(const Vec3& /*direction*/) const override { return radiance_; }

  private:
    bool sample_direction(const Vec2& u, SkyDirection& direction) const override;
    float direction_density(const Vec3& wi) const override;
    bool direction_coordinates(const Vec3& wi, Vec2& u) const override;

    Rgb radiance_;
};

/// Latitude-longitude image times a colour. In the light's space +z is the image's top row.
class MappedEnvironment final : public EnvironmentLight {
  public:
    MappedEnvironment(const LightPlacement& placement, const SceneSphere& sphere,
                      const Rotation& rotation, LatLongMap map, const Rgb& scale);
    Rgb escaped(const Vec3& direction) const override;

  private:
    bool sample_direction(const Vec2& u, SkyDirection& direction) const override;
    float direction_density(const Vec3& wi) const override;
    bool direction_coordinates(const Vec3& wi, Vec2& u) const override;

    Rotation rotation_;
    LatLongMap map_;
    Piecewise2D importance_;
    Rgb scale_;
};

}  // namespace lxs
