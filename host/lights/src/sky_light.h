// Light of the clear sky.
#pragma once

#include <variant>

#include "environment_light.h"
#include "hosek_wilkie_sky.h"
#include "piecewise_2d.h"
#include "rotation.h"
#include "sky_model.h"

namespace lxs {

/// The sky's radiance in its own space, +z up.
using AnySky = std::variant<SkyModel, HosekWilkieSky>;

/// Directions below the horizon shine like the horizon above them, as in LuxRender 1.9.
class SkyLight final : public EnvironmentLight {
  public:
    SkyLight(const LightPlacement& placement, const SceneSphere& sphere, const Rotation& rotation,
             const AnySky& model, float gain);
    Rgb escaped(const Vec3& direction) const override;

  private:
    bool sample_direction(const Vec2& u, SkyDirection& direction) const override;
    float direction_density(const Vec3& wi) const override;
    bool direction_coordinates(const Vec3& wi, Vec2& u) const override;
    /// Radiance of the unit direction `local` before gain.
    Rgb radiance(const Vec3& local) const;

    Rotation rotation_;
    AnySky model_;
    Piecewise2D importance_;  ///< over azimuth and height, equal solid angles
    float gain_;
};

}  // namespace lxs
