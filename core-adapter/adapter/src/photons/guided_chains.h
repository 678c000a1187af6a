// Chains in the adaptive guide's place: photon paths from Markov chains that start at independent
// paths drawn where visible ones were found before. See docs/understand/chain-starts.md.
#pragma once

#include "aips/core/chains/spread_chain.h"
#include "aips/core/chains/start_pool.h"
#include "guides/adaptive/chain_starts.h"
#include "photons/photon_source.h"

namespace aips {

/// Whether some pass may take its photon paths from these.
inline bool may_guide_chains(const Settings& s) {
    return s.guide == GuideKind::Adaptive && s.guide_scout && s.guide_chains &&
           s.guide_chain_starts;
}

/// A pass first draws a fixed number of independent paths, which measure the share of visible ones.
/// Then chains spread the weight of those that were visible over the paths around them. Their
/// number is fixed, each is sequential, and what they leave is joined in order: the result does not
/// depend on the number of threads. Of several ranks each walks with chains of its own, whose state
/// the others need not know.
class GuidedChains : public PhotonSource {
  public:
    /// All of these outlive it; `light_choice`: by power.
    GuidedChains(const Scene& scene, const Settings& settings,
                 const DiscreteDistribution& light_choice);

    float reach(const SearchRadii& radii) const override;
    void mark_reach(std::span<const Vec3> visible_points, float radius) override;
    std::uint64_t begin_pass(const PassPhotons& photons, const GuidedPass& pass) override;
    std::uint32_t iteration_paths() const override;
    PhotonCounts trace(const PhotonInput& input, const IterationPaths& paths, Refusals& refusals,
                       const PathTraces& traces) override;
    double end_pass() override;
    void state(StateArchive& archive) override;
    void learned(LearnedParts& parts) override;
    void add_to(EngineStatistics& statistics) const override;
    std::size_t memory_bytes() const override;
    static std::size_t memory_bound_bytes(const Scene& scene, const Settings& settings,
                                          std::size_t eye_paths);

  private:
    /// What a visible path leaves.
    struct Visible {
        std::vector<Landing> landings;
        double cost = 0;  ///< in rays
    };
    using Chain = SpreadChain<Visible>;
    struct Tracer;
    struct Drawn;
    struct Walked;

    std::uint32_t left_to_measure() const { return measured_ - std::uint32_t(pass_.measured); }
    /// Draws independent paths, which measure unless those of the pass have all been drawn.
    PhotonCounts draw(const PhotonInput& input, std::uint32_t count, Refusals& refusals);
    void draw(Tracer& tracer, std::uint32_t job, std::uint32_t count, Drawn& drawn) const;
    void take(const Drawn& drawn, bool measuring, double u);
    /// Goes on from what was measured.
    PhotonCounts walk(const PhotonInput& input, std::uint32_t count, Refusals& refusals,
                      LandingStore& store);
    void walk(Tracer& tracer, std::uint32_t chain, std::uint32_t count, Walked& walked);
    std::uint64_t start_of(const PhotonInput& input, std::uint64_t segment) const;
    void learn_mutation_size();
    double visible_share() const { return weights_.sum / double(measured_); }

    ChainStarts starts_;
    std::vector<Chain> chains_;
    // The false hits of hashed occupancy would outnumber the visible paths of a wide scene.
    PointGrid reach_;
    MutationSize mutation_size_;
    // Of this pass.
    std::uint32_t paths_ = 0, measured_ = 0;
    std::uint64_t segment_steps_ = 1, segments_ = 1;
    StartPool pool_;      // of the measured paths, the visible ones
    WeightSums weights_;  // of these
    ChainCounts pass_;
    /// Of the last pass: as many starts of equal weight as its visible paths are worth, for each
    /// measured path.
    double start_share_ = 0;
    ChainCounts not_learned_, totals_;
    WeightSums all_weights_;
};

}  // namespace aips
