// Probability of choosing each light, in proportion to its power: for photons, for light in media,
// and for shadow rays before they have learned (light_tables.h).
#pragma once

#include "aips/adapter/scene.h"
#include "aips/core/tables/discrete_distribution.h"

namespace aips {

/// False for a dead light: it is never chosen.
bool emits(const Light& light);

/// Distribution over Scene::lights(); empty if no light emits.
DiscreteDistribution light_choice(const Scene& scene);

}  // namespace aips
