// Radiance over an emitting surface: a constant or a texture, times a scale.
#include "emitted_radiance.h"

#include <cmath>

namespace lxs {

Rgb non_negative(const Rgb& c) {
    const auto clean = [](float v) { return v > 0 && std::isfinite(v) ? v : 0.0f; };
    return Rgb(clean(c.x), clean(c.y), clean(c.z));
}

EmittedRadiance::EmittedRadiance(std::shared_ptr<const ColorTexture> texture)
    : texture_(std::move(texture)) {
    const std::optional<Rgb> value = texture_ ? texture_->constant() : Rgb(1.0f);
    constant_ = value.has_value();
    if (constant_) value_ = non_negative(*value);
}

Rgb EmittedRadiance::textured(const Vec3& p, const Vec3& n, const Vec2& uv) const {
    return non_negative(texture_->evaluate({p, n, uv})) * scale_;
}

}  // namespace lxs
