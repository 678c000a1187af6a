// Reads textured parameters: a value written in place or the name of a texture.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

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

/// The lists one after the other.
std::vector<ParameterDeclaration> declarations(
    std::initializer_list<std::vector<ParameterDeclaration>> lists);

/// A string parameter that takes one of `choices`, which must outlive it.
ParameterDeclaration choice(std::string_view name, std::string_view fallback, std::string_view doc,
                            std::span<const std::string_view> choices);

/// What differs between float, colour and fresnel textures, for plugins that exist for several.
template <class T>
struct TextureKind;

template <>
struct TextureKind<float> {
    static constexpr ParameterType kParameter = ParameterType::FloatTexture;
    static constexpr ParameterType kValue = ParameterType::Float;
    static constexpr std::string_view kBlack = "0", kMortar = "0.2", kWhite = "1";
    using Factory = FloatTextureFactory;
    static float value(const ParameterReader& reader, std::string_view name, float fallback) {
        return static_cast<float>(reader.number(name, fallback));
    }
    static std::shared_ptr<const FloatTexture> read(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name, float fallback) {
        return read_float_texture(reader, assets, name, fallback);
    }
};

template <>
struct TextureKind<Rgb> {
    static constexpr ParameterType kParameter = ParameterType::ColorTexture;
    static constexpr ParameterType kValue = ParameterType::Color;
    static constexpr std::string_view kBlack = "0 0 0", kMortar = "0.2 0.2 0.2", kWhite = "1 1 1";
    using Factory = ColorTextureFactory;
    static Rgb value(const ParameterReader& reader, std::string_view name, float fallback) {
        return reader.color(name, Rgb(fallback));
    }
    static std::shared_ptr<const ColorTexture> read(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name, float fallback) {
        return read_color_texture(reader, assets, name, Rgb(fallback));
    }
};

/// Numbers are indices of dielectrics, that of vacuum if none is given.
template <>
struct TextureKind<FresnelValue> {
    static constexpr ParameterType kParameter = ParameterType::FresnelTexture;
    static constexpr ParameterType kValue = ParameterType::Float;
    static constexpr std::string_view kBlack = "1", kWhite = "1";
    using Factory = FresnelTextureFactory;
    static FresnelValue value(const ParameterReader& reader, std::string_view name, float) {
        return {Rgb(static_cast<float>(reader.number(name, 1)))};
    }
    static std::shared_ptr<const FresnelTexture> read(const ParameterReader& reader,
                                                      const AssetContext& assets,
                                                      std::string_view name, float) {
        return read_fresnel_texture(reader, assets, name, 1);
    }
};

}  // namespace lxs::shading
