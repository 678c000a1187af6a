// The noise that textures of the blender_* family are made of.
#include "blender_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cell_points.h"
#include "perlin_noise.h"
#include "texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 10> kBases{
    "blender_original", "original_perlin", "improved_perlin", "voronoi_f1",      "voronoi_f2",
    "voronoi_f3",       "voronoi_f4",      "voronoi_f2_f1",   "voronoi_crackle", "cell_noise"};
constexpr std::array<std::string_view, 2> kNoiseTypes{"soft_noise", "hard_noise"};

float voronoi(NoiseBasis basis, const Vec3& p) {
    const auto d = nearest_points(p, DistanceMetric::Actual, 0);
    constexpr float kCrackle = 10;  // steepness beside the borders of cells
    switch (basis) {
        case NoiseBasis::VoronoiF2:
            return d[1];
        case NoiseBasis::VoronoiF3:
            return d[2];
        case NoiseBasis::VoronoiF4:
            return d[3];
        case NoiseBasis::VoronoiF2F1:
            return d[1] - d[0];
        case NoiseBasis::VoronoiCrackle:
            return kCrackle * (d[1] - d[0]);
        default:
            return d[0];
    }
}

}  // namespace

float basis_noise(NoiseBasis basis, const Vec3& p) {
    float value = 0;
    if (basis <= NoiseBasis::ImprovedPerlin) {
        value = 0.5f + 0.5f * perlin_noise(p);
    } else if (basis == NoiseBasis::CellNoise) {
        value = cell_value(p);
    } else {
        value = voronoi(basis, p);
    }
    return std::clamp(value, 0.0f, 1.0f);
}

ParameterDeclaration basis_parameter(std::string_view name, std::string_view doc) {
    return choice(name, kBases.front(), doc, kBases);
}

NoiseBasis read_basis(const ParameterReader& reader, std::string_view name) {
    const std::string basis = reader.string(name, kBases.front());
    return static_cast<NoiseBasis>(std::find(kBases.begin(), kBases.end(), basis) - kBases.begin());
}

float BlenderNoise::operator()(const Vec3& p) const {
    float sum = 0, weight = 1, total = 0;
    Vec3 place = p / size;
    for (int i = 0; i <= depth; ++i) {
        const float value = basis_noise(basis, place);
        sum += weight * (hard ? std::abs(2 * value - 1) : value);
        total += weight;
        weight *= 0.5f;
        place *= 2;
    }
    return sum / total;
}

std::vector<ParameterDeclaration> noise_parameters(bool octaves) {
    constexpr double kSmallest = 1e-6, kDeepest = 30;
    std::vector<ParameterDeclaration> all{
        choice("noisetype", "soft_noise", "hard noise has creases", kNoiseTypes),
        basis_parameter("noisebasis", "kind of noise; the three Perlin bases look alike"),
        {"noisesize", ParameterType::Float, "0.25", "size of the noise's cells", kSmallest}};
    if (octaves) {
        all.push_back({"noisedepth", ParameterType::Integer, "2",
                       "octaves after the first, each half as large", 0, kDeepest});
    }
    return all;
}

BlenderNoise read_noise(const ParameterReader& reader, bool octaves) {
    BlenderNoise noise;
    noise.basis = read_basis(reader, "noisebasis");
    noise.hard = reader.string("noisetype", "soft_noise") == "hard_noise";
    noise.size = static_cast<float>(reader.number("noisesize", 0.25));
    if (octaves) noise.depth = static_cast<int>(reader.integer("noisedepth", 2));
    return noise;
}

float Levels::operator()(float value) const {
    return std::clamp((value - 0.5f) * contrast + bright - 0.5f, 0.0f, 1.0f);
}

std::vector<ParameterDeclaration> levels_parameters() {
    return {{"bright", ParameterType::Float, "1", "shift of the value by bright - 1"},
            {"contrast", ParameterType::Float, "1", "spread of the values about 0.5"}};
}

Levels read_levels(const ParameterReader& reader) {
    return {static_cast<float>(reader.number("bright", 1)),
            static_cast<float>(reader.number("contrast", 1))};
}

}  // namespace lxs::shading
