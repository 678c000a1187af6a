// Lights at a point: isotropic, and spot with a falloff.
#pragma once

#include "lxs/lights/lights.h"
#include "warp.h"

namespace lxs {

/// Isotropic light at a point.
class PointLight : public PlacedLight {
  public:
    /// `intensity` in W/sr.
    PointLight(const LightPlacement& placement, const Vec3& position, const Rgb& intensity)
        : PlacedLight(placement), position_(position), intensity_(intensity) {}

    std::string_view kind() const override { return "point"; }
    float power() const override { return 4 * kPi * luminance(intensity_); }
    bool is_delta() const override { return true; }
    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3&, const Vec3&, const Vec3&, const Vec3&, const Vec3&,
                     std::uint32_t) const override {
        return 0;
    }
    bool emission_coordinates(const Vec3& p, const DirectSample& sample,
                              PrimaryPoint& u) const override;

  protected:
    const Rgb& intensity() const { return intensity_; }
    /// Share of `intensity` sent along the unit vector `w`.
    virtual float falloff(const Vec3& /*w*/) const { return 1; }
    /// Direction drawn in proportion to the falloff.
    virtual Vec3 sample_direction(double u0, float u1) const { return uniform_sphere(u0, u1); }
    /// Inverse of sample_direction in [0, 1)^2 for a unit direction where the falloff is positive.
    virtual Imath::V2d direction_coordinates(const Vec3& w) const { return from_uniform_sphere(w); }
    /// Integral of the falloff over the sphere of directions.
    virtual float falloff_integral() const { return 4 * kPi; }

  private:
    Vec3 position_;
    Rgb intensity_;
};

/// Half angles of a spot's cone, radians: constant up to `inner`, nothing beyond `outer`.
struct SpotCone {
    float inner = 0;
    float outer = 0;
    bool smooth = false;  ///< a smoothstep of the cosine in between (pbrt-v4), not a fourth power
};

/// Spot light: within the transition the intensity falls with the fourth power of the cosine's
/// share (Pharr & Humphreys 2010, section 12.2.1, the law of LuxRender's spot), or as a smoothstep
/// of it.
class SpotLight final : public PointLight {
  public:
    SpotLight(const LightPlacement& placement, const Vec3& position, const Vec3& axis,
              const Rgb& intensity, const SpotCone& cone);

    std::string_view kind() const override { return "spot"; }
    float power() const override { return falloff_integral() * luminance(intensity()); }

  private:
    float falloff(const Vec3& w) const override;
    Vec3 sample_direction(double u0, float u1) const override;
    Imath::V2d direction_coordinates(const Vec3& w) const override;
    float falloff_integral() const override;

    /// Within the transition, from the cosine's share in [0, 1]: the intensity; its integral from 0
    /// on as a share of the whole one; the inverse of that.
    float fall(float share) const;
    float fallen(float share) const;
    float share_of(float fallen) const;
    /// The whole integral, over the transition's width in 1 - cosine.
    float fade() const { return (outer_ - inner_) / (smooth_ ? 2 : 5); }

    Frame frame_;
    // 1 - cosine, which keeps narrow cones precise.
    float inner_ = 0, outer_ = 0;
    bool smooth_ = false;
};

}  // namespace lxs
