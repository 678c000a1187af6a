// A colour given as a spectrum.
#pragma once

#include "lxs/scene/texture.h"
#include "lxs/spectrum/spectrum.h"

namespace lxs::shading {

/// The same spectrum everywhere. As Rgb it has one colour on surfaces and another in lights, see
/// colour_of_surface() and colour_of_light().
class SpectralTexture final : public ColorTexture {
  public:
    /// `name`: of its spectrum in messages.
    SpectralTexture(const Spectrum& spectrum, std::string name);

    Rgb evaluate(const TexturePoint& point) const override {
        return point.use == ColourUse::Light ? light_ : surface_;
    }
    std::optional<Rgb> constant() const override { return surface_; }
    CurvePointer spectrum() const override { return curve_; }

  private:
    Rgb surface_, light_;
    CurvePointer curve_;
};

}  // namespace lxs::shading
