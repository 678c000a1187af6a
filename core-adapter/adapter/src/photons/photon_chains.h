// photonsampler=amc: photon paths from adaptive Markov chains (Hachisuka & Jensen 2011).
#pragma once

#include <algorithm>
#include <bit>

#include "aips/core/chains/visibility_chain.h"
#include "estimate/gather_radii.h"
#include "photons/constants.h"
#include "photons/photon_iteration.h"

namespace aips {

/// Whether some pass may take its photon paths from chains.
inline bool may_use_chains(const Settings& s) {
    return s.photon_sampler == PhotonSampler::AdaptiveChains;
}

/// Chains of a pass of so many paths.
constexpr std::uint32_t chain_count(std::uint32_t paths) {
    return std::clamp(std::bit_floor(paths / kPathsPerChain), kChainCount, kMostChains);
}

/// Share of chain `c` of `chains` of `paths` paths. Rounds but the last share evenly, so that the
/// shares of the rounds add up to the share of the pass.
constexpr std::uint32_t chain_share(std::uint32_t c, std::uint32_t chains, std::uint32_t paths) {
    return paths / chains + (c < paths % chains ? 1 : 0);
}

/// A chain's state that lasted several steps lands once, with the power of all of them.
void record_state(std::span<const Photon> state, std::uint32_t repeats,
                  std::vector<Photon>& photons);

/// Chains that walk among the photon paths which reach visible points. Their number follows from
/// that of the pass's paths, each is sequential, and their photons are joined in order: the result
/// does not depend on the number of threads. See docs/understand/chains.md for what is exact about
/// them.
class PhotonChains {
  public:
    /// How far from a visible point (scene units) photons count as visible.
    static float reach(const GatherRadii& radii) {
        return std::max(kChainReach * radii.mean, radii.reach());
    }
    /// Where paths have to land to be visible, from the next pass until it is told anew.
    void mark_reach(std::span<const Vec3> visible_points, float radius);

    /// Chains forget their paths: those of the last pass are not distributed as this pass's
    /// visible points and radius ask for. The size of mutations is kept. `paths`: of this pass.
    void begin_pass(std::uint32_t paths);

    /// Photon paths of the next round: short at first, so that the first visible path soon serves
    /// all chains.
    std::uint32_t round_paths() const;

    /// Traces exactly `count` photon paths, independent and mutated ones together, and appends the
    /// photons of the recorded states. A path is visible when it leaves a photon within reach of
    /// a visible point; `input.occupancy` must be there and `input.guide` must not.
    PhotonCounts trace(const PhotonInput& input, std::uint32_t count, InvalidSampleFilter& filter,
                       PhotonStore& store);

    /// Ends the pass. Returns what this pass's photons, summed, must be multiplied with to stand
    /// for as many independent photon paths as the pass has: visible / measured * paths / recorded.
    /// 0 when no measured path was visible: then the pass says that they found nothing.
    double end_pass();

    /// Between passes: saves what outlives a pass, the size of mutations and counts, or restores
    /// it.
    void state(StateArchive& archive);

    /// Over the whole render.
    const ChainCounts& totals() const { return totals_; }
    double mutation_size() const { return mutation_size_.size(); }
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(const Settings& settings, std::uint32_t eye_paths);

  private:
    using Chain = VisibilityChain<std::vector<Photon>>;

    /// From the mutations since it last learned; nothing before each chain had one.
    void learn_mutation_size();
    void spread_states();
    std::uint32_t chains() const { return std::uint32_t(chains_.size()); }

    std::vector<Chain> chains_ = std::vector<Chain>(kChainCount);
    // The false hits of hashed occupancy would outnumber the visible paths of a wide scene.
    PointGrid reach_;
    MutationSize mutation_size_;
    std::uint32_t paths_ = 0;  // of this pass
    ChainCounts pass_, not_learned_, totals_;
};

}  // namespace aips
