// Densities in space that are formulas: "exponential" and "noisecloud".
#include <algorithm>
#include <cmath>

#include "formula_texture.h"
#include "perlin_noise.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

std::shared_ptr<const FloatTexture> create_exponential(const ParameterReader& reader,
                                                       const AssetContext&,
                                                       const Matrix& to_world) {
    const Vec3 origin = reader.vector("origin", Vec3(0.0f));
    const Vec3 up = reader.vector("updir", Vec3(0, 0, 1)).normalized();
    const auto decay = static_cast<float>(reader.number("decay", 1));
    return formula_texture<float>(
        [=, mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
            return std::exp(-decay * ((mapping(point) - origin) ^ up));
        });
}

/// A cloud with a flat base: noise of five octaves, thinner the higher, between heights 0 and 1
/// (the medium "cloud" of pbrt-v4). `wisps`: how far places are moved along the slope of finer
/// noise.
float noise_cloud(const Vec3& p, float density, float wisps, float frequency) {
    constexpr float kLacunarity = 1.99f;  // of perlin_noise.h's sums
    constexpr float kStep = 0.01f;        // of the slopes
    if (!std::isfinite(p.x + p.y + p.z)) return 0;
    Vec3 place = p * frequency;
    float size = 0.05f * wisps, scale = 10;
    for (int octave = 0; octave < 2 && wisps > 0; ++octave) {
        const Vec3 at = place * scale;
        const float here = perlin_noise(at);
        Vec3 slope;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 beside = at;
            beside[axis] += kStep;
            slope[axis] = (perlin_noise(beside) - here) / kStep;
        }
        place += slope * size;
        size *= 0.5f;
        scale *= kLacunarity;
    }
    const float noise = 0.5f * fractal_sum(place, 0.5f, 5);
    const float thinner = std::clamp((1 - p.y) * 4.5f * density * noise, 0.0f, 1.0f);
    return std::min(thinner + 2 * std::max(0.0f, 0.5f - p.y), 1.0f);
}

std::shared_ptr<const FloatTexture> create_noisecloud(const ParameterReader& reader,
                                                      const AssetContext&, const Matrix& to_world) {
    const auto density = static_cast<float>(reader.number("density", 1));
    const auto wispiness = static_cast<float>(reader.number("wispiness", 1));
    const auto frequency = static_cast<float>(reader.number("frequency", 5));
    return formula_texture<float>(
        [=, mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
            return noise_cloud(mapping(point), density, wispiness, frequency);
        });
}

}  // namespace

void register_density_textures(Registry& registry) {
    registry.float_textures["exponential"] = {
        declarations({{{"origin", ParameterType::Point, "0 0 0", "where the density is 1"},
                       {"updir", ParameterType::Vector, "0 0 1", "direction of the fall-off"},
                       {"decay", ParameterType::Float, "1",
                        "fall-off per unit of length: the density is exp(-decay * height)"}},
                      space_mapping_parameters()}),
        &create_exponential};
    registry.float_textures["noisecloud"] = {
        declarations({{{"density", ParameterType::Float, "1", "how much of the noise is cloud", 0},
                       {"wispiness", ParameterType::Float, "1", "how torn its edges are", 0},
                       {"frequency", ParameterType::Float, "5", "of its largest lumps"}},
                      space_mapping_parameters()}),
        &create_noisecloud};
}

}  // namespace lxs::shading
