// Texture "mix": a blend of two textures.
#include "binary_texture.h"
#include "fresnel_arithmetic.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

template <class T>
typename TextureKind<T>::Factory mix_plugin() {
    using Kind = TextureKind<T>;
    return {{{"tex1", Kind::kParameter, Kind::kBlack, "value where amount is 0"},
             {"tex2", Kind::kParameter, Kind::kWhite, "value where amount is 1"},
             {"amount", ParameterType::FloatTexture, "0.5", "share of tex2, 0 to 1"}},
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                return std::make_shared<MixTexture<T>>(
                    Kind::read(reader, assets, "tex1", 0), Kind::read(reader, assets, "tex2", 1),
                    read_float_texture(reader, assets, "amount", 0.5f));
            }};
}

}  // namespace

void register_mixes(Registry& registry) {
    registry.float_textures["mix"] = mix_plugin<float>();
    registry.color_textures["mix"] = mix_plugin<Rgb>();
    registry.fresnel_textures["mix"] = mix_plugin<FresnelValue>();
}

}  // namespace lxs::shading
