// A light as a spectral render sees it: what it emits, at the wavelengths of the pass.
#pragma once

#include "lxs/sdk/light.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

class SpectralLight final : public Light {
  public:
    /// All must outlive this; `wavelengths` may change from pass to pass. `unit`: what the light's
    /// spectrum has there at luminance 1; null if it was given as a colour.
    SpectralLight(const Light& light, const Wavelengths& wavelengths, const Rgb* unit)
        : light_(light), wavelengths_(wavelengths), unit_(unit) {}

    /// Of the light's own colour, in R, G and B: the same at the wavelengths.
    Rgb at_wavelengths(const Rgb& rgb) const {
        return unit_ ? *unit_ * luminance(rgb) : wavelengths_.values_of(rgb);
    }

    std::string_view kind() const override { return light_.kind(); }
    std::uint32_t group() const override { return light_.group(); }
    float power() const override { return light_.power(); }
    bool at_infinity() const override { return light_.at_infinity(); }
    bool hidden_from_camera() const override { return light_.hidden_from_camera(); }
    bool is_delta() const override { return light_.is_delta(); }
    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3& p, const Vec3& n, const Vec3& wi, const Vec3& light_p,
                     const Vec3& light_n, std::uint32_t primitive) const override {
        return light_.pdf_direct(p, n, wi, light_p, light_n, primitive);
    }
    bool emission_coordinates(const Vec3& p, const DirectSample& sample,
                              PrimaryPoint& u) const override {
        return light_.emission_coordinates(p, sample, u);
    }
    Rgb escaped(const Vec3& direction) const override {
        return at_wavelengths(light_.escaped(direction));
    }

  private:
    const Light& light_;
    const Wavelengths& wavelengths_;
    const Rgb* unit_;
};

}  // namespace lxs
