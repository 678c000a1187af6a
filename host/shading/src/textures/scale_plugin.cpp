// Texture "scale": the product of two textures.
#include "binary_texture.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

template <class T>
typename TextureKind<T>::Factory scale_plugin() {
    using Kind = TextureKind<T>;
    return {{{"tex1", Kind::kParameter, "1", "first factor"},
             {"tex2", Kind::kParameter, "1", "second factor"}},
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                return std::make_shared<ScaleTexture<T>>(Kind::read(reader, assets, "tex1", 1),
                                                         Kind::read(reader, assets, "tex2", 1));
            }};
}

}  // namespace

FloatTextureFactory scale_float_plugin() {
    return scale_plugin<float>();
}
ColorTextureFactory scale_color_plugin() {
    return scale_plugin<Rgb>();
}

}  // namespace lxs::shading
