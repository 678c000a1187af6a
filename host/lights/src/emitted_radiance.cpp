// Radiance over an emitting surface: a constant or a texture, times a scale.
#include "emitted_radiance.h"

#include <cmath>

#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {

Rgb non_negative(const Rgb& c) {
    const auto clean = [](float v) { return v > 0 && std::isfinite(v) ? v : 0.0f; };
    return Rgb(clean(c.x), clean(c.y), clean(c.z));
}

EmittedRadiance::EmittedRadiance(std::shared_ptr<const ColorTexture> texture, std::string name,
                                 const Matrix& to_world)
    : texture_(std::move(texture)), name_(std::move(name)), to_shape_(to_world.inverse()) {
    if (texture_ && texture_->reads_image()) given_as_ = Given::AsImage;
    if (texture_ && texture_->spectrum()) given_as_ = Given::AsSpectrum;
    constant_ = !texture_ || texture_->constant().has_value();
    if (constant_) value_ = texture_ ? colour(Vec3(0.0f), Vec3(0.0f), Vec2(0.0f)) : Rgb(1.0f);
}

Rgb EmittedRadiance::colour(const Vec3& p, const Vec3& n, const Vec2& uv) const {
    TexturePoint point{p, n, uv};
    point.use = ColourUse::Light;
    point.object_to_shape = &to_shape_;
    const Rgb value = texture_->evaluate(point);
    if (!is_finite(value) || is_negative(value)) refused_->count(name_);
    return light_of(non_negative(value));
}

Rgb EmittedRadiance::light_of(const Rgb& value) const {
    if (given_as_ == Given::AsSpectrum) return value * kLuminanceOfFlatSpectrum;
    return given_as_ == Given::AsImage ? colour_of_filtered_illuminant(value, Rgb(1.0f))
                                       : colour_of_illuminant(value);
}

}  // namespace lxs
