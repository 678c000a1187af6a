// One bounce of a photon: the one-sample mixture of Bsdf and guide.
#pragma once

#include "eye/surface_normals.h"
#include "photons/photon_path.h"

namespace aips {

/// Direction that a photon takes, and what its power is multiplied with.
struct ScatteredPhoton {
    Vec3 direction;
    Rgb weight;
    bool straight = false;
    std::int8_t component = kAllComponents;  ///< as in BsdfSample
    LobeMask lobe = 0;  ///< from which the Bsdf alone drew it; 0: a mixture of densities did
    /// Of `direction` per steradian where a mixture drew it, given that no specular lobe was
    /// chosen.
    float pdf = 0;
    float plain_pdf = 0;  ///< the same without a guide
};

/// Most numbers that scatter_photon draws: whether a specular lobe, which of a mixture's densities,
/// two for the direction and one for the lobe.
inline constexpr std::uint32_t kScatterNumbers = 5;

/// Draws a direction from `random` (RandomStream or PrimaryPath); false when the photon is
/// absorbed. Specular lobes are never guided.
template <class Numbers>
bool scatter_photon(const PhotonInput& input, const SurfacePoint& point, Vec3 wo, Numbers& random,
                    Arena& arena, PhotonCounts& counts, ScatteredPhoton& result);

/// Veach's factor for photons at shading normals (1997, section 5.3.2): with it, photon power
/// counts flux through the geometric surface while the Bsdf takes cosines to the shading normal.
/// Bounded where the photon comes along the surface, see normal_ratio.
float adjoint_shading_factor(const SurfacePoint& point, Vec3 wo, Vec3 wi);

}  // namespace aips
