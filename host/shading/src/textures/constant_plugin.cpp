// Texture "constant": one value everywhere.
#include "lxs/scene/constant_texture.h"
#include "texture_plugins.h"

namespace lxs::shading {

FloatTextureFactory constant_float_plugin() {
    return {{{"value", ParameterType::Float, "1", "value everywhere"}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                const auto value = static_cast<float>(reader.number("value", 1));
                return std::make_shared<ConstantTexture<float>>(value);
            }};
}

ColorTextureFactory constant_color_plugin() {
    return {{{"value", ParameterType::Color, "1 1 1", "colour everywhere, linear RGB"}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                return std::make_shared<ConstantTexture<Rgb>>(reader.color("value", Rgb(1.0f)));
            }};
}

FresnelTextureFactory constant_fresnel_plugin() {
    return {{{"value", ParameterType::Float, "1.5", "index of refraction", 1e-3}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                FresnelValue value;
                value.eta = Rgb(static_cast<float>(reader.number("value", 1.5)));
                return std::make_shared<ConstantTexture<FresnelValue>>(value);
            }};
}

}  // namespace lxs::shading
