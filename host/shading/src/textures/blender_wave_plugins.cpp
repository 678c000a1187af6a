// Textures of waves: "blender_marble", "blender_wood" and "blender_magic"; and the gradient
// "blender_blend".
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "blender_plugin.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

constexpr std::array<std::string_view, 3> kWaves{"sin", "saw", "tri"};

/// A wave of period 2 pi in [0, 1], by its name.
float wave(const std::string& form, float phase) {
    if (form == "sin") return 0.5f + 0.5f * std::sin(phase);
    const float share = phase / (2 * kPi) - std::floor(phase / (2 * kPi));
    return form == "saw" ? share : 1 - 2 * std::abs(share - 0.5f);
}

ParameterDeclaration wave_parameter() {
    return choice("noisebasis2", "sin", "form of the wave", kWaves);
}
ParameterDeclaration turbulence_parameter(std::string_view doc) {
    return {"turbulence", ParameterType::Float, "5", doc};
}
float turbulence(const ParameterReader& reader) {
    return static_cast<float>(reader.number("turbulence", 5));
}

constexpr std::array<std::string_view, 3> kMarbles{"soft", "sharp", "sharper"};

FloatTextureFactory marble_plugin() {
    std::vector<ParameterDeclaration> own = noise_parameters(true);
    own.push_back(choice("type", "soft", "how narrow the dark veins are", kMarbles));
    own.push_back(wave_parameter());
    own.push_back(turbulence_parameter("radians by which noise shifts the veins"));
    return blender_plugin(own, [](const ParameterReader& reader) {
        const std::string type = reader.string("type", "soft");
        const std::string form = reader.string("noisebasis2", "sin");
        const float power = type == "soft" ? 1.0f : type == "sharp" ? 0.5f : 0.25f;
        return [=, noise = read_noise(reader, true), shift = turbulence(reader)](const Vec3& p) {
            constexpr float kFrequency = 5;  // radians per unit of length
            const float phase = kFrequency * (p.x + p.y + p.z) + shift * noise(p);
            return std::pow(wave(form, phase), power);
        };
    });
}

constexpr std::array<std::string_view, 4> kWoods{"bands", "rings", "bandnoise", "ringnoise"};

FloatTextureFactory wood_plugin() {
    std::vector<ParameterDeclaration> own = noise_parameters(false);
    own.push_back(choice("type", "bands", "planes or spheres, smooth or shifted by noise", kWoods));
    own.push_back(wave_parameter());
    own.push_back(turbulence_parameter("radians by which noise shifts bandnoise and ringnoise"));
    return blender_plugin(own, [](const ParameterReader& reader) {
        const std::string type = reader.string("type", "bands");
        const std::string form = reader.string("noisebasis2", "sin");
        const float shift = type.ends_with("noise") ? turbulence(reader) : 0;
        return [=, rings = type.starts_with("ring"),
                noise = read_noise(reader, false)](const Vec3& p) {
            constexpr float kBands = 10, kRings = 20;  // radians per unit of length
            const float phase = rings ? kRings * p.length() : kBands * (p.x + p.y + p.z);
            return wave(form, phase + (shift != 0 ? shift * noise(p) : 0));
        };
    });
}

/// Sines of sums of the coordinates; `depth` times, one of the three is made of all of them anew.
/// The mean of three channels.
float magic(const Vec3& p, int depth, float strength) {
    constexpr float kFrequency = 5;  // radians per unit of length
    Vec3 s(std::sin((p.x + p.y + p.z) * kFrequency), std::cos((p.y - p.x - p.z) * kFrequency),
           -std::cos((p.z - p.x - p.y) * kFrequency));
    for (int i = 0; i < depth; ++i) {
        const int changed = (i + 1) % 3;
        s[changed] = -std::cos(strength * (s[i % 3] - s[changed] + s[(i + 2) % 3]));
    }
    return 0.5f - (s.x + s.y + s.z) / 6;
}

FloatTextureFactory magic_plugin() {
    constexpr double kDeepest = 10;
    return blender_plugin({{"noisedepth", ParameterType::Integer, "2",
                            "how often waves are made of waves", 0, kDeepest},
                           turbulence_parameter("radians by which waves bend each other")},
                          [](const ParameterReader& reader) {
                              const auto depth = static_cast<int>(reader.integer("noisedepth", 2));
                              const float strength = turbulence(reader);
                              return [=](const Vec3& p) { return magic(p, depth, strength); };
                          });
}

constexpr std::array<std::string_view, 7> kBlends{"lin",    "quad", "ease",  "diag",
                                                  "sphere", "halo", "radial"};

/// A gradient over x (and y) from -1 to 1, or over the distance from the origin up to 1.
float blend(const std::string& type, const Vec3& p) {
    const float linear = std::clamp((1 + p.x) / 2, 0.0f, 1.0f);
    const float ball = std::max(0.0f, 1 - p.length());
    if (type == "quad") return linear * linear;
    if (type == "ease") return linear * linear * (3 - 2 * linear);
    if (type == "diag") return std::clamp((2 + p.x + p.y) / 4, 0.0f, 1.0f);
    if (type == "sphere") return ball;
    if (type == "halo") return ball * ball;
    if (type == "radial") return std::atan2(p.y, p.x) / (2 * kPi) + 0.5f;
    return linear;
}

FloatTextureFactory blend_plugin() {
    return blender_plugin({choice("type", "lin", "form of the gradient", kBlends),
                           {"flipxy", ParameterType::Bool, "false", "exchanges x and y"}},
                          [](const ParameterReader& reader) {
                              return [type = reader.string("type", "lin"),
                                      flip = reader.boolean("flipxy", false)](const Vec3& p) {
                                  return blend(type, flip ? Vec3(p.y, p.x, p.z) : p);
                              };
                          });
}

}  // namespace

void register_blender_waves(Registry& registry) {
    registry.float_textures["blender_marble"] = marble_plugin();
    registry.float_textures["blender_wood"] = wood_plugin();
    registry.float_textures["blender_magic"] = magic_plugin();
    registry.float_textures["blender_blend"] = blend_plugin();
}

}  // namespace lxs::shading
