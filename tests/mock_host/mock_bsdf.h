// Materials of the mock host, each with a closed-form albedo.
#pragma once

#include <memory_resource>
#include <optional>

#include "aips/adapter/bsdf.h"

namespace mock {

/// What a surface is made of.
struct Material {
    enum class Kind { Lambert, Mirror, Glass, Null, Phong, LambertAndMirror, Sheet };
    Kind kind = Kind::Lambert;
    aips::Rgb reflectance{0.5f, 0.5f, 0.5f};  ///< of the diffuse (or only) lobe
    aips::Rgb specular{0, 0, 0};              ///< of the mirror lobe of LambertAndMirror, Sheet
    aips::Rgb transmittance{0, 0, 0};         ///< Sheet: of the diffuse lobe behind it
    aips::Rgb glossy{0, 0, 0};                ///< Sheet: of the lobe around the mirror direction
    float index = 1.5f;         ///< Glass: refractive index behind the surface over that before it
    float exponent = 30;        ///< Phong, Sheet: lobe around the mirror direction
    bool hide_lambert = false;  ///< Lambert: do not offer the compact form (tests both code paths)
    std::optional<float> claimed_pdf = {};  ///< Lambert: what all its densities are said to be
};

/// Builds the Bsdf in `memory`; `ng` and `ns` are unit and in one hemisphere.
const aips::Bsdf* make_bsdf(const Material& material, aips::Vec3 ng, aips::Vec3 ns,
                            std::pmr::memory_resource& memory);

/// Most memory that make_bsdf takes.
std::size_t max_bsdf_bytes();

}  // namespace mock
