// What photons add to the statistics of a render.
#pragma once

#include "aips/adapter/engine.h"
#include "photons/photon_pass.h"

namespace aips {

void add_photons(const PhotonPassTotals& totals, EngineStatistics& statistics);
void add_chains(const PhotonChains& chains, EngineStatistics& statistics);
void add_guide(const AdaptiveGuide& guide, EngineStatistics& statistics);

}  // namespace aips
