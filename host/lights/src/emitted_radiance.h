// Radiance over an emitting surface: a constant or a texture, times a scale.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lxs/scene/refused_values.h"
#include "lxs/scene/texture.h"

namespace lxs {

class EmittedRadiance {
  public:
    /// `name`: of the texture, for the count of what is refused. `to_world`: from the shape's own
    /// space, where textures with "local" coordinates lie.
    EmittedRadiance(std::shared_ptr<const ColorTexture> texture, std::string name,
                    const Matrix& to_world);
    void scale_by(float factor) { scale_ *= factor; }
    bool is_constant() const { return constant_; }
    /// The spectrum of which the radiance has the colour, if it is a constant given as one; else
    /// null.
    CurvePointer spectrum() const { return texture_ ? texture_->spectrum() : nullptr; }
    /// Counts values of the texture that were not finite or negative.
    RefusedValues& refused_values() const { return *refused_; }
    /// Radiance in W sr^-1 m^-2, finite and >= 0.
    Rgb at(const Vec3& p, const Vec3& n, const Vec2& uv) const {
        return (constant_ ? value_ : colour(p, n, uv)) * scale_;
    }

  private:
    /// LuxRender takes images for filters of white light.
    enum class Given : std::uint8_t { AsColour, AsImage, AsSpectrum };

    /// The light that a value of the texture stands for.
    Rgb light_of(const Rgb& value) const;
    Rgb colour(const Vec3& p, const Vec3& n, const Vec2& uv) const;  ///< of the texture

    std::shared_ptr<const ColorTexture> texture_;
    std::string name_;
    Matrix to_shape_;
    std::unique_ptr<RefusedValues> refused_ = std::make_unique<RefusedValues>();
    Rgb value_{0.0f};
    float scale_ = 1;
    bool constant_ = true;
    Given given_as_ = Given::AsColour;
};

/// Negative and non-finite components set to zero.
Rgb non_negative(const Rgb& c);

}  // namespace lxs
