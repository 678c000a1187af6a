// The noise that textures of the blender_* family are made of. It matches Blender's in kind and in
// statistics, not value by value.
#pragma once

#include <vector>

#include "lxs/sdk/parameters.h"
#include "lxs/sdk/types.h"

namespace lxs::shading {

/// In the order of basis_names().
enum class NoiseBasis : std::uint8_t {
    BlenderOriginal,
    OriginalPerlin,
    ImprovedPerlin,
    VoronoiF1,
    VoronoiF2,
    VoronoiF3,
    VoronoiF4,
    VoronoiF2F1,
    VoronoiCrackle,
    CellNoise
};

/// Noise of one frequency in [0, 1].
float basis_noise(NoiseBasis basis, const Vec3& p);

/// The parameter `name` that names a basis, and its value.
ParameterDeclaration basis_parameter(std::string_view name, std::string_view doc);
NoiseBasis read_basis(const ParameterReader& reader, std::string_view name);

/// Noise summed over octaves, in [0, 1].
struct BlenderNoise {
    NoiseBasis basis = NoiseBasis::BlenderOriginal;
    bool hard = false;  ///< with creases at 0
    float size = 0.25f;
    int depth = 0;  ///< octaves after the first

    float operator()(const Vec3& p) const;
};

/// "noisetype", "noisebasis", "noisesize" and, if it has more than one octave, "noisedepth".
std::vector<ParameterDeclaration> noise_parameters(bool octaves);
BlenderNoise read_noise(const ParameterReader& reader, bool octaves);

/// Brightness and contrast, the last step of each texture: [0, 1] to [0, 1].
struct Levels {
    float bright = 1, contrast = 1;

    float operator()(float value) const;
};

std::vector<ParameterDeclaration> levels_parameters();
Levels read_levels(const ParameterReader& reader);

}  // namespace lxs::shading
