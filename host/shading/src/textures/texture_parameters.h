// Reads textured parameters: a value written in place or the name of a texture.
#pragma once

#include <memory>
#include <string_view>

#include "lxs/scene/constant_texture.h"
#include "lxs/scene/registry.h"

namespace lxs::shading {

std::shared_ptr<const FloatTexture> read_float_texture(const ParameterReader& reader,
                                                       const AssetContext& assets,
                                                       std::string_view name, float fallback);
std::shared_ptr<const ColorTexture> read_color_texture(const ParameterReader& reader,
                                                       const AssetContext& assets,
                                                       std::string_view name, const Rgb& fallback);
/// A plain number is the index of a dielectric.
std::shared_ptr<const FresnelTexture> read_fresnel_texture(const ParameterReader& reader,
                                                           const AssetContext& assets,
                                                           std::string_view name, float fallback);

/// What differs between float and colour textures, for plugins that exist for both.
template <class T>
struct TextureKind;

template <>
struct TextureKind<float> {
    static constexpr ParameterType kParameter = ParameterType::FloatTexture;
    using Factory = FloatTextureFactory;
    static std::shared_ptr<const FloatTexture> read(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name, float fallback) {
        return read_float_texture(reader, assets, name, fallback);
    }
};

template <>
struct TextureKind<Rgb> {
    static constexpr ParameterType kParameter = ParameterType::ColorTexture;
    using Factory = ColorTextureFactory;
    static std::shared_ptr<const ColorTexture> read(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name, float fallback) {
        return read_color_texture(reader, assets, name, Rgb(fallback));
    }
};

}  // namespace lxs::shading
