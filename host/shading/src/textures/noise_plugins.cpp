// Textures of Perlin noise: "fbm", "wrinkled", "windy" and "marble".
#include <algorithm>
#include <array>
#include <cmath>

#include "formula_texture.h"
#include "perlin_noise.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

constexpr int kMostOctaves = 64;

ParameterDeclaration octaves_parameter() {
    return {"octaves",
            ParameterType::Integer,
            "8",
            "number of noise frequencies summed, each 1.99 "
            "times the one before",
            1,
            kMostOctaves};
}

ParameterDeclaration roughness_parameter(std::string_view fallback) {
    return {"roughness", ParameterType::Float, fallback,
            "weight of each octave relative to the one before", 0};
}

int octaves(const ParameterReader& reader) {
    return static_cast<int>(reader.integer("octaves", 8));
}
float number(const ParameterReader& reader, std::string_view name, double fallback) {
    return static_cast<float>(reader.number(name, fallback));
}

/// A sum over octaves of noise, `sum(p, roughness, octaves)`.
FloatTextureFactory octave_plugin(float (*sum)(const Vec3&, float, int), double roughness,
                                  std::string_view roughness_text) {
    return {
        declarations({{octaves_parameter(), roughness_parameter(roughness_text)},
                      space_mapping_parameters()}),
        [=](const ParameterReader& reader, const AssetContext&, const Matrix& to_world) {
            return formula_texture<float>(
                [sum, mapping = SpaceMapping(reader, to_world), octaves = octaves(reader),
                 roughness = number(reader, "roughness", roughness)](const TexturePoint& point) {
                    return sum(mapping(point), roughness, octaves);
                });
        }};
}

/// Wind over water: small waves, stronger where the wind is (Pharr and Humphreys, section 11.6.5).
float windy(const Vec3& p) {
    constexpr float kGustScale = 0.1f;
    return std::abs(fractal_sum(p * kGustScale, 0.5f, 3)) * fractal_sum(p, 0.5f, 6);
}

/// Control colours of the marble's spline: a pale stone with a bluish vein. Colours of our own, as
/// LuxRender's could not be had but from its source.
const std::array<Rgb, 9> kMarble = {
    Rgb(.60f, .60f, .61f), Rgb(.59f, .59f, .60f), Rgb(.57f, .57f, .58f),
    Rgb(.52f, .52f, .53f), Rgb(.61f, .60f, .59f), Rgb(.57f, .57f, .60f),
    Rgb(.55f, .55f, .58f), Rgb(.22f, .23f, .32f), Rgb(.58f, .58f, .61f)};

/// Colour at `t` in [0, 1]: cubic Bezier pieces, each a control point further than the last.
Rgb marble_colour(float t) {
    constexpr float kContrast = 1.5f;
    constexpr std::size_t kPieces = kMarble.size() - 3;
    const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(kPieces);
    const std::size_t first = std::min(static_cast<std::size_t>(place), kPieces - 1);
    const float s = place - static_cast<float>(first), r = 1 - s;
    return (kMarble[first] * (r * r * r) + kMarble[first + 1] * (3 * r * r * s) +
            kMarble[first + 2] * (3 * r * s * s) + kMarble[first + 3] * (s * s * s)) *
           kContrast;
}

std::shared_ptr<const ColorTexture> create_marble(const ParameterReader& reader,
                                                  const AssetContext&, const Matrix& to_world) {
    const SpaceMapping mapping(reader, to_world);
    const float variation = number(reader, "variation", 0.2);
    const float roughness = number(reader, "roughness", 0.5), scale = number(reader, "scale", 1);
    return formula_texture<Rgb>([=, octaves = octaves(reader)](const TexturePoint& point) {
        const Vec3 p = mapping(point) * scale;
        const float layer = p.y + variation * fractal_sum(p, roughness, octaves);
        if (!std::isfinite(layer)) return Rgb(layer);  // no colour: refused by whoever asked
        return marble_colour(0.5f + 0.5f * std::sin(layer));
    });
}

}  // namespace

void register_noise_textures(Registry& registry) {
    registry.float_textures["fbm"] = octave_plugin(&fractal_sum, 0.8, "0.8");
    registry.float_textures["wrinkled"] = octave_plugin(&turbulence, 0.5, "0.5");
    registry.float_textures["windy"] = {
        space_mapping_parameters(),
        [](const ParameterReader& reader, const AssetContext&, const Matrix& to_world) {
            return formula_texture<float>(
                [mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
                    return windy(mapping(point));
                });
        }};
    registry.color_textures["marble"] = {
        declarations({{octaves_parameter(),
                       roughness_parameter("0.5"),
                       {"scale", ParameterType::Float, "1", "factor on the position"},
                       {"variation", ParameterType::Float, "0.2",
                        "how far noise bends the layers, in texture units"}},
                      space_mapping_parameters()}),
        &create_marble};
}

}  // namespace lxs::shading
