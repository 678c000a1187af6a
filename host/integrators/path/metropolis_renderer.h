// Passes of `path` under Sampler "metropolis": many chains side by side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/metropolis_chain.h"
#include "path/metropolis_target.h"
#include "path/path_tracer.h"

namespace lxs {

/// Runs a number of chains that depends on the image's size alone, each from pass to pass; a pass
/// makes as many mutations as the film has pixels. The first pass also draws plain samples: they
/// estimate b and seed the chains. b is estimated further from all large steps; each pass is scaled
/// by the estimate from before it, since one from its own samples would be correlated with them.
class MetropolisRenderer {
  public:
    MetropolisRenderer(const RenderContext& context, const PathTracer& tracer,
                       const MetropolisSettings& settings);

    /// Adds one pass to the film, or none as long as no plain sample has found light.
    PathCounts render_pass();
    /// One line for the log.
    std::string text() const;
    Statistics statistics() const;

  private:
    /// A chain, its share of a pass and what it did with it.
    struct Lane {
        MetropolisChain chain;
        std::uint64_t mutations = 0;
        std::size_t first_splat = 0;
        std::size_t splats = 0;
        ChainCounts counts{};
        PathCounts paths{};
    };

    PathCounts seed_chains();
    std::vector<double> plain_brightness(PathCounts& counts) const;
    void start_chains(const std::vector<double>& brightness, double total);
    void run_lane(Lane& lane, const MeanBrightness& b, PathTarget& target);
    void splat();
    RandomStream plain_sample(std::uint64_t index) const;
    double mean_brightness() const;

    RenderContext context_;
    const PathTracer& tracer_;
    MetropolisSettings settings_;
    std::vector<Lane> lanes_;
    std::vector<Vec2> positions_;
    std::vector<Rgb> radiance_;
    double guess_ = 0;  ///< of b, from the samples that seeded the chains; 0 until one had light
    double plain_brightness_ = 0;
    std::uint64_t plain_samples_ = 0;
    ChainCounts total_;
    bool warned_ = false;
};

}  // namespace lxs
