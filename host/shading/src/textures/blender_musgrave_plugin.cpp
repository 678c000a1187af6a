// Texture "blender_musgrave": the multifractals of Musgrave.
#include <algorithm>
#include <array>
#include <cmath>

#include "blender_plugin.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 5> kTypes{"multifractal", "ridged_multifractal",
                                                 "hybrid_multifractal", "hetero_terrain", "fBm"};

/// Musgrave, chapter 16 of Ebert et al. 2003, "Texturing and Modeling: A Procedural Approach".
struct Musgrave {
    enum class Type : std::uint8_t { Multifractal, Ridged, Hybrid, HeteroTerrain, Fbm };

    Type type = Type::Multifractal;
    NoiseBasis basis = NoiseBasis::BlenderOriginal;
    float h, lacunarity, octaves, offset, gain, scale, size;

    float operator()(const Vec3& p) const { return scale * std::max(value(p / size), 0.0f); }

  private:
    float value(Vec3 p) const;
};

/// All five go over octaves that shrink by `lacunarity` and fade by its power -h; they differ in
/// how an octave depends on those before. The last octave counts in part.
float Musgrave::value(Vec3 p) const {
    const bool product = type == Type::Multifractal;
    float sum = product ? 1.0f : 0.0f, weight = 1, fade = 1;
    for (float left = octaves; left > 0; --left) {
        const float share = std::min(left, 1.0f);
        const float noise = 2 * basis_noise(basis, p) - 1;
        switch (type) {
            case Type::Multifractal:
                sum *= 1 + share * noise * fade;
                break;
            case Type::Fbm:
                sum += share * noise * fade;
                break;
            case Type::HeteroTerrain:
                // The first octave stands alone, later ones grow with the height so far.
                sum += share * (noise + offset) * fade * (left == octaves ? 1 : sum);
                break;
            case Type::Hybrid:
                sum += share * std::min(weight, 1.0f) * (noise + offset) * fade;
                weight = std::min(weight, 1.0f) * gain * (noise + offset) * fade;
                break;
            case Type::Ridged: {
                const float ridge = (offset - std::abs(noise)) * (offset - std::abs(noise));
                sum += share * weight * ridge * fade;
                weight = std::clamp(ridge * gain * weight, 0.0f, 1.0f);
                break;
            }
        }
        p *= lacunarity;
        fade *= std::pow(lacunarity, -h);
    }
    return sum;
}

Musgrave read(const ParameterReader& reader) {
    const auto number = [&](std::string_view name, double fallback) {
        return static_cast<float>(reader.number(name, fallback));
    };
    const std::string type = reader.string("type", "multifractal");
    Musgrave musgrave{};
    musgrave.type =
        static_cast<Musgrave::Type>(std::find(kTypes.begin(), kTypes.end(), type) - kTypes.begin());
    musgrave.basis = read_basis(reader, "noisebasis");
    musgrave.h = number("h", 1);
    musgrave.lacunarity = number("lacu", 2);
    musgrave.octaves = number("octs", 2);
    musgrave.offset = number("offset", 1);
    musgrave.gain = number("gain", 1);
    musgrave.scale = number("outscale", 1);
    musgrave.size = number("noisesize", 0.25);
    return musgrave;
}

}  // namespace

FloatTextureFactory blender_musgrave_plugin() {
    constexpr double kSmallest = 1e-6, kMostOctaves = 30;
    return blender_plugin(
        {choice("type", "multifractal", "kind of fractal", kTypes),
         basis_parameter("noisebasis", "kind of noise"),
         {"noisesize", ParameterType::Float, "0.25", "size of the largest cells", kSmallest},
         {"h", ParameterType::Float, "1", "how fast octaves fade: by lacu^-h"},
         {"lacu", ParameterType::Float, "2", "lacunarity: frequency of each octave over the last",
          kSmallest},
         {"octs", ParameterType::Float, "2", "number of octaves, may be fractional", 0,
          kMostOctaves},
         {"offset", ParameterType::Float, "1",
          "shift of the noise (hetero_terrain, hybrid, ridged)"},
         {"gain", ParameterType::Float, "1", "weight of later octaves (hybrid, ridged)"},
         {"outscale", ParameterType::Float, "1", "factor on the value"}},
        &read);
}

}  // namespace lxs::shading
