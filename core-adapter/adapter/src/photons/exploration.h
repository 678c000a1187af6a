// Before the first pass, where next to no photon path is seen: Markov chains look for those that
// are, and tell a guide where they start. They bring no light into the image. See
// docs/understand/chains.md.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/adapter/settings.h"
#include "aips/core/tables/discrete_distribution.h"
#include "eye/eye_pass.h"
#include "guides/adaptive/emission_seed.h"

namespace aips {

/// Whether it may be.
inline bool may_explore(const Settings& s) {
    return s.guide == GuideKind::Adaptive && s.pilot_pass && s.guide_chains;
}

/// Where visible paths start.
struct Exploration {
    /// Those of one light in succession. Weights are in proportion to the visible paths around.
    std::vector<EmissionSeed> starts;
    std::uint64_t paths = 0;  ///< photon paths that were followed
};

/// A path is visible when it lands within kChainReach times `radius` (scene units, > 0) of a
/// visible point of `image`. Rounds of independent paths, the first by seeds from the eye and by
/// power, the later ones also by what was found, take turns with rounds of chains, which walk on
/// from those that were visible; until kLearnedScores were, or kMostExploringRounds are done, or
/// kRoundsWithFinds that found some.
/// `light_choice`: by power, not empty. The paths have numbers of their own. The result depends
/// neither on the number of threads nor on that of ranks.
Exploration explore_starts(const Scene& scene, const Settings& settings,
                           const DiscreteDistribution& light_choice, float time,
                           const EyeImage& image, float radius);

/// Upper bound of the memory that it takes meanwhile, and of what it returns.
std::size_t exploration_memory_bound(const Scene& scene, const Settings& settings,
                                     std::size_t eye_paths);

}  // namespace aips
