// Materials: build a Bsdf at a surface point.
#pragma once

#include <memory_resource>
#include <vector>

#include "lxs/scene/texture.h"
#include "lxs/sdk/bsdf.h"
#include "lxs/sdk/medium.h"

namespace lxs {

/// What a material reads of a surface point.
struct ShadingPoint {
    TexturePoint texture;
    Vec3 ng{0.0f};    ///< geometric normal, unit
    Vec3 ns{0.0f};    ///< shading normal, unit, in the hemisphere of ng
    Vec3 dpdu{0.0f};  ///< tangent along u; zero when unknown. As uv, only where they are needed
    /// Tangent along v; only known where MaterialFacts::bends or reads_dpdv, else zero.
    Vec3 dpdv{0.0f};
    bool bent = false;  ///< ns is already what Material::bend made of it
    const Medium* interior = nullptr;
    const Medium* exterior = nullptr;
    std::int8_t component = kAllComponents;  ///< Ray::component of the ray that came
};

/// What a material can do anywhere on a surface, known when the scene is loaded.
struct MaterialFacts {
    LobeMask lobes = 0;  ///< all kinds that may occur
    bool transmits = false;
    bool straight = false;        ///< may pass light undeviated (null, architectural glass, mixes)
    bool index_of_media = false;  ///< bends light by the indices of the media on its sides
    bool own_index = false;       ///< bends light by an index of its own, in vacuum
    bool reads_image = false;
    bool disperses = false;   ///< bends each wavelength its own way
    bool bends = false;       ///< has a bump or normal map, itself or in a part of it
    bool reads_dpdv = false;  ///< needs the tangent along v even if it doesn't bend
    bool reads_uv =
        true;  ///< needs texture coordinates, or the tangent along u, if it doesn't bend
    std::size_t max_bsdf_bytes = 0;  ///< most memory that one scatter() takes
    /// Colours of it that are given as spectra: reflectances, transmittances, absorptions.
    std::vector<CurvePointer> spectra = {};

    void add_spectra_of(const MaterialFacts& part) {
        spectra.insert(spectra.end(), part.spectra.begin(), part.spectra.end());
    }
};

class Material {
  public:
    virtual ~Material() = default;
    /// Tilts `point.ns` by the material's own bump map and sets `point.bent`, for callers that let
    /// integrators see the tilted normal. Where nobody calls it, the Bsdf takes its cosines to the
    /// normal that stands there and has the bump in its values. Only needed if facts().bends.
    virtual void bend(ShadingPoint& /*point*/) const {}
    /// Builds the Bsdf in `memory`; null when nothing scatters (black).
    virtual const Bsdf* scatter(const ShadingPoint& point,
                                std::pmr::memory_resource& memory) const = 0;
    virtual MaterialFacts facts() const = 0;
    /// Share of light that passes straight through to a shadow ray that goes on along `direction`,
    /// towards the light (null material: 1;
    /// architectural glass: its transmission; mixes: the mean); 0 for everything else. Shadow rays
    /// multiply it. Only called if facts().straight.
    virtual Rgb straight_transmittance(const ShadingPoint& /*point*/,
                                       const Vec3& /*direction*/) const {
        return Rgb(0.0f);
    }
};

}  // namespace lxs
