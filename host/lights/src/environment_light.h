// Base of lights at infinity: photons come through a disk as wide as the scene's sphere.
#pragma once

#include <optional>

#include "lxs/lights/lights.h"

namespace lxs {

/// A direction towards a light at infinity.
struct SkyDirection {
    Vec3 wi{0.0f};       ///< unit, towards the light
    Rgb radiance{0.0f};  ///< for a single direction: irradiance on a surface facing it
    float pdf = 0;       ///< per steradian; 1 for a single direction
    bool delta = false;
};

class EnvironmentLight : public PlacedLight {
  public:
    std::string_view kind() const override { return kind_; }
    float power() const override { return fluence_ * crossed_area(); }
    bool at_infinity() const override { return true; }

    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3& /*p*/, const Vec3& /*n*/, const Vec3& wi, const Vec3& /*light_p*/,
                     const Vec3& /*light_n*/, std::uint32_t /*primitive*/) const override {
        return direction_density(wi);
    }
    bool emission_coordinates(const Vec3& p, const DirectSample& sample,
                              PrimaryPoint& u) const override;

  protected:
    /// `kind` must outlive the light (a literal).
    EnvironmentLight(const LightPlacement& placement, std::string_view kind,
                     const SceneSphere& sphere);

    virtual bool sample_direction(const Vec2& u, SkyDirection& direction) const = 0;
    virtual float direction_density(const Vec3& wi) const = 0;
    /// Inverse of sample_direction, in [0, 1)^2, for a unit direction; false if it isn't drawn.
    /// A coordinate that the direction does not depend on stays.
    virtual bool direction_coordinates(const Vec3& wi, Vec2& u) const = 0;
    /// Sets power() from the integral of the radiance over all directions, of which none stands
    /// out.
    void set_fluence(const Rgb& fluence);
    /// The same for light that comes from about one direction (unit).
    void set_fluence(const Rgb& fluence, const Vec3& from);

  private:
    /// Area across its direction of the light that is emitted.
    float crossed_area() const;
    /// How far from the disc through the sphere's centre, towards the light, a photon starts that
    /// passes `foot` there; nothing if it misses all surfaces. `spread` in [0, 1) moves the start.
    std::optional<double> start_ahead(const Imath::V3d& foot, const Imath::V3d& wi,
                                      double spread) const;

    /// Its light then starts on the sphere, where that begins.
    bool in_medium() const { return media() != EnteredMedia(); }

    std::string_view kind_;
    SceneSphere sphere_;
    double margin_ = 0;  ///< between the surfaces' box and where photons start
    float fluence_ = 0;  ///< luminance
    Vec3 facing_{0.5f};  ///< mean cosines under which faces across x, y and z see the light
};

}  // namespace lxs
