// A photon: one stored arrival of a photon path at a surface.
#pragma once

#include <cstdint>

#include "aips/core/base/rgb.h"
#include "aips/core/base/vector.h"

namespace aips {

/// One arrival of a photon path, before it scatters.
struct Photon {
    Vec3 position;           ///< where it landed
    Vec3 direction;          ///< unit, back to where the photon came from
    Rgb power;               ///< watts, not divided by the number of photon paths
    Vec3 previous;           ///< where the path last left a surface, or the light
    Vec3 normal;             ///< unit geometric normal of the surface, of either side
    std::uint32_t path = 0;  ///< number of the photon path in its pass
    /// Surfaces met so far, this one included: 1 from the light; kDeepestPhoton stands for more.
    std::uint16_t depth : 11 = 0;
    /// Its last surface let it go by a specular lobe: there is no node of a guide.
    std::uint16_t from_specular : 1 = 0;
    /// Light that eye paths may carry as well: the first surface that turned it away scattered it
    /// diffusely or glossily.
    std::uint16_t shareable : 1 = 0;
    /// Light that shadow rays bring to the image: a guide may learn from it, nothing gathers it.
    std::uint16_t owned_by_shadow_rays : 1 = 0;
    /// ImagePart of what it brings to a surface that the eye sees straight or by way of specular
    /// ones.
    std::uint16_t part : 2 = 0;
    std::uint16_t light_group = 0;  ///< group of the light that emitted the path
    /// Light that no eye path from a glossy surface finds: of a delta light, by way of specular
    /// surfaces alone.
    std::uint32_t found_alone : 1 = 0;
    /// Number of that light, for statistics alone; kLastLight stands for those beyond.
    std::uint32_t light : 21 = 0;
    /// Scatterings before it landed that were not straight; kMostPhotonBounces stands for more.
    std::uint32_t bounces : 10 = 0;
};
/// A million of them wait for a gather.
static_assert(sizeof(Photon) == 72);

inline constexpr std::uint32_t kDeepestPhoton = (1u << 11) - 1;
inline constexpr std::uint32_t kLastLight = (1u << 21) - 1;
inline constexpr std::uint32_t kMostPhotonBounces = (1u << 10) - 1;

}  // namespace aips
