// What photons add to the statistics of a render.
#include "strategies/photon_statistics.h"

#include "plan/skip_log.h"

namespace aips {

void add_photons(const PhotonPassTotals& totals, EngineStatistics& s) {
    s.photon_paths += totals.counts.paths;
    s.photon_rays += totals.counts.rays;
    s.landings += totals.counts.landings;
    s.split_off += totals.counts.split_off;
    s.bounces += totals.counts.bounces;
    s.guided_bounces += totals.counts.guided_bounces;
    s.gathered += totals.gathered;
    s.photon_seconds += totals.photon_seconds;
    s.gather_seconds += totals.gather_seconds;
    s.guide_seconds += totals.guide_seconds;
}

void add_chains(const PhotonChains& chains, EngineStatistics& s) {
    s.measured_paths = chains.totals().measured;
    s.visible_paths = chains.totals().visible;
    s.mutation_size = chains.mutation_size();
}

void add_guide(const AdaptiveGuide& guide, EngineStatistics& s) {
    s.guide_nodes = guide.node_count();
    s.guide_bytes = guide.memory_bytes();
    s.emission_gain = guide.emission_guide().gain();
    s.survival_gain = guide.survival_gain();
    if (const BounceGuide* bounces = guide.bounces()) {
        s.bounce_gain = bounces->tables().gain();
        s.bounce_tables = bounces->tables().tables_in_use();
    }
    s.score_times_cost = guide.score_times_cost();
    s.pruned_emission = guide.emission_guide().starved_share(kPrunedDensity);
}

}  // namespace aips
