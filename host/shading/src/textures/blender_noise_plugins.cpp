// Textures of plain noise: "blender_clouds", "blender_distortednoise", "blender_noise",
// "blender_stucci" and "blender_voronoi".
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "blender_plugin.h"
#include "cell_points.h"
#include "hashed_bits.h"
#include "ignored_parameter.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

FloatTextureFactory clouds_plugin() {
    return blender_plugin(noise_parameters(true),
                          [](const ParameterReader& reader) { return read_noise(reader, true); });
}

/// Noise whose place another noise displaces.
FloatTextureFactory distortednoise_plugin() {
    constexpr double kSmallest = 1e-6;
    return blender_plugin(
        {basis_parameter("noisebasis", "kind of noise that is displaced"),
         basis_parameter("type", "kind of noise that displaces it"),
         {"noisesize", ParameterType::Float, "0.25", "size of the noise's cells", kSmallest},
         ignored("noisedepth", ParameterType::Integer, "2", "distorted noise has one octave"),
         {"distamount", ParameterType::Float, "1", "strength of the displacement, in cells"}},
        [](const ParameterReader& reader) {
            const NoiseBasis basis = read_basis(reader, "noisebasis");
            const NoiseBasis distortion = read_basis(reader, "type");
            const auto size = static_cast<float>(reader.number("noisesize", 0.25));
            const auto amount = static_cast<float>(reader.number("distamount", 1));
            return [=](const Vec3& p) {
                constexpr float kApart = 13.5f;  // between the places that displace x, y and z
                const Vec3 q = p / size;
                const auto shift = [&](float offset) {
                    return amount * (2 * basis_noise(distortion, q + Vec3(offset)) - 1);
                };
                return basis_noise(basis, q + Vec3(shift(kApart), shift(0), shift(-kApart)));
            };
        });
}

/// Another value at every point.
float white_noise(const Vec3& p) {
    std::uint32_t bits = 0;
    for (int axis = 0; axis < 3; ++axis)
        bits = hashed(bits + std::bit_cast<std::uint32_t>(p[axis]));
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

constexpr std::array<std::string_view, 3> kStucci{"plastic", "wall_in", "wall_out"};

/// Noise at a place that noise has moved along z: flat grounds with dents or bumps.
FloatTextureFactory stucci_plugin() {
    std::vector<ParameterDeclaration> own = noise_parameters(false);
    own.push_back(
        choice("type", "plastic", "plastic, or a wall with dents or with bumps", kStucci));
    own.push_back({"turbulence", ParameterType::Float, "5", "how far the noise is displaced"});
    return blender_plugin(own, [](const ParameterReader& reader) {
        const std::string type = reader.string("type", "plastic");
        const auto turbulence = static_cast<float>(reader.number("turbulence", 5));
        return [=, noise = read_noise(reader, false)](const Vec3& p) {
            constexpr float kUnit = 200;  // turbulence that moves by a unit of length
            const float ground = noise(p);
            const float shift = turbulence / kUnit * (type == "plastic" ? 1 : ground * ground);
            const float value = noise(p + Vec3(0, 0, shift));
            return type == "wall_out" ? 1 - value : value;
        };
    });
}

// In the order of DistanceMetric, Minkowski's name in both of its spellings.
constexpr std::array<std::string_view, 10> kMetrics{
    "actual_distance", "distance_squared", "manhattan",      "chebychev",      "minkovsky_half",
    "minkovsky_four",  "minkovsky",        "minkowsky_half", "minkowsky_four", "minkowsky"};

DistanceMetric read_metric(const ParameterReader& reader) {
    const std::string name = reader.string("distmetric", kMetrics.front());
    const auto index = std::find(kMetrics.begin(), kMetrics.end(), name) - kMetrics.begin();
    return static_cast<DistanceMetric>(index <= 6 ? index : index - 3);
}

/// Weighted sum of the distances to the four nearest points.
FloatTextureFactory voronoi_plugin() {
    constexpr double kSmallest = 1e-6, kLeastExponent = 0.01;
    return blender_plugin(
        {choice("distmetric", "actual_distance", "how distances are measured", kMetrics),
         {"minkowsky_exp", ParameterType::Float, "2.5", "exponent of the metric \"minkowsky\"",
          kLeastExponent},
         {"minkovsky_exp", ParameterType::Float, "2.5", "the same, as others spell it",
          kLeastExponent},
         ignored("nabla", ParameterType::Float, "0.025", "step of LuxRender's bump mapping"),
         {"noisesize", ParameterType::Float, "0.25", "mean distance of the points", kSmallest},
         {"outscale", ParameterType::Float, "1", "factor on the value"},
         {"w1", ParameterType::Float, "1", "weight of the distance to the nearest point"},
         {"w2", ParameterType::Float, "0", "weight of the second distance"},
         {"w3", ParameterType::Float, "0", "weight of the third distance"},
         {"w4", ParameterType::Float, "0", "weight of the fourth distance"}},
        [](const ParameterReader& reader) {
            const auto number = [&](std::string_view name, double fallback) {
                return static_cast<float>(reader.number(name, fallback));
            };
            const DistanceMetric metric = read_metric(reader);
            const std::array<float, 4> weights{number("w1", 1), number("w2", 0), number("w3", 0),
                                               number("w4", 0)};
            float total = 0;
            for (const float weight : weights)
                total += std::abs(weight);
            const float scale = total > 0 ? number("outscale", 1) / total : 0;
            return
                [=, size = number("noisesize", 0.25),
                 exponent = number("minkowsky_exp", number("minkovsky_exp", 2.5))](const Vec3& p) {
                    const auto d = nearest_points(p / size, metric, exponent);
                    float sum = 0;
                    for (std::size_t i = 0; i < d.size(); ++i)
                        sum += weights[i] * d[i];
                    return scale * std::abs(sum);
                };
        });
}

}  // namespace

void register_blender_noises(Registry& registry) {
    registry.float_textures["blender_clouds"] = clouds_plugin();
    registry.float_textures["blender_distortednoise"] = distortednoise_plugin();
    registry.float_textures["blender_noise"] =
        blender_plugin({ignored("noisedepth", ParameterType::Integer, "2", "it is white noise")},
                       [](const ParameterReader&) { return &white_noise; });
    registry.float_textures["blender_stucci"] = stucci_plugin();
    registry.float_textures["blender_voronoi"] = voronoi_plugin();
}

}  // namespace lxs::shading
