// How photons of guide=adaptive find their way in a scene, found out before its first pass.
//
// A guide sends photons where the image sees them. Where most are seen anyway there is nothing to
// gain, and what learning costs, and photons that count for less while it learns, would be lost
// (docs/understand/chains.md).
#pragma once

#include "aips/adapter/settings.h"
#include "eye/eye_pass.h"

namespace aips {

/// Of `traced` unguided photon paths (> 0), how many are seen.
struct SeenPaths {
    std::uint64_t near = 0;  ///< land within two radii of a visible point
    std::uint64_t seen = 0;  ///< within the radius
    std::uint64_t traced = 0;

    /// In [0, 1]. The first takes visible surfaces whole, however small the radius.
    double near_share() const { return double(near) / double(traced); }
    double seen_share() const { return double(seen) / double(traced); }
};

/// Follows unguided photon paths and counts those that land within `radius` (scene units, > 0) of a
/// visible point of `image`. The paths have numbers of their own and bring nothing into the image:
/// its expectation does not depend on what is made of the counts, but for what the photons' part of
/// the first pass, one of many, has to do with them by its eye paths.
SeenPaths trace_pilot_pass(const Scene& scene, const Settings& settings, float time,
                           const EyeImage& image, float radius);

/// What takes photons through the scene under guide=adaptive.
enum class PhotonWay : std::uint8_t {
    Guided,
    Unguided  ///< the guide is left out: a third of the photon paths comes near what is seen
};

PhotonWay photon_way(const SeenPaths& seen);

/// Whether so few are seen that a guide would have next to nothing to learn from.
bool seen_too_seldom(const SeenPaths& seen);

}  // namespace aips
