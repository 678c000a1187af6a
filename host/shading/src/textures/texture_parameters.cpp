// Reads textured parameters.
#include "texture_parameters.h"

namespace lxs::shading {

std::shared_ptr<const FloatTexture> read_float_texture(const ParameterReader& reader,
                                                       const AssetContext& assets,
                                                       std::string_view name, float fallback) {
    if (const auto texture = reader.texture_name(name)) {
        if (auto found = assets.float_texture(*texture, reader.where(name))) return found;
    }
    const auto value = static_cast<float>(reader.number(name, fallback));
    return std::make_shared<ConstantTexture<float>>(value);
}

std::shared_ptr<const ColorTexture> read_color_texture(const ParameterReader& reader,
                                                       const AssetContext& assets,
                                                       std::string_view name, const Rgb& fallback) {
    if (const auto texture = reader.texture_name(name)) {
        if (auto found = assets.color_texture(*texture, reader.where(name))) return found;
    }
    return std::make_shared<ConstantTexture<Rgb>>(reader.color(name, fallback));
}

std::shared_ptr<const FresnelTexture> read_fresnel_texture(const ParameterReader& reader,
                                                           const AssetContext& assets,
                                                           std::string_view name, float fallback) {
    if (const auto texture = reader.texture_name(name)) {
        if (auto found = assets.fresnel_texture(*texture, reader.where(name))) return found;
    }
    FresnelValue value;
    value.eta = Rgb(static_cast<float>(reader.number(name, fallback)));
    return std::make_shared<ConstantTexture<FresnelValue>>(value);
}

std::vector<ParameterDeclaration> declarations(
    std::initializer_list<std::vector<ParameterDeclaration>> lists) {
    std::vector<ParameterDeclaration> all;
    for (const auto& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

ParameterDeclaration choice(std::string_view name, std::string_view fallback, std::string_view doc,
                            std::span<const std::string_view> choices) {
    ParameterDeclaration declaration{name, ParameterType::String, fallback, doc};
    declaration.choices = choices;
    return declaration;
}

}  // namespace lxs::shading
