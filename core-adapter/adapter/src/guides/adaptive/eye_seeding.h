// Emission seeds: short walks from visible points to the lights name the primary coordinates from
// which a photon would reach what the eye sees. A guide that never shot such a photon learns from
// them where to begin; they shape its density and are never part of the image.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/tables/discrete_distribution.h"
#include "eye/eye_pass.h"
#include "guides/adaptive/constants.h"
#include "guides/adaptive/emission_seed.h"

namespace aips {

/// Connections to a light per walk: the visible point, each surface met, a light met.
inline constexpr std::uint32_t kMaxSeedsPerWalk = kMaxSeedBounces + 3;

/// What finding seeds cost.
struct SeedCounts {
    std::uint64_t walks = 0;
    std::uint64_t rays = 0;  ///< shadow rays included
};

/// Walks from one visible point of each group of kSeedGroup: a cosine-distributed direction, on
/// through surfaces that are specular only; at each surface met, and at the visible point itself
/// where photons own direct light, a light is chosen by `light_choice` and connected; a light met
/// after a specular bounce counts too. Media around the visible points are taken for vacuum.
/// `seeds` is refilled, at most kMaxSeedsPerWalk a group; the result does not depend on the number
/// of threads.
void find_emission_seeds(const Scene& scene, const Settings& settings,
                         const DiscreteDistribution& light_choice, std::uint64_t pass, float time,
                         const EyeImage& image, std::vector<EmissionSeed>& seeds,
                         SeedCounts& counts);

}  // namespace aips
