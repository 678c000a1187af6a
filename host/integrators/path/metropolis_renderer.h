// Passes of `path` under Sampler "metropolis".
#pragma once

#include <string>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/metropolis_population.h"
#include "path/metropolis_target.h"
#include "path/path_tracer.h"

namespace lxs {

/// Runs a population of chains over eye paths, and hands what each pass gives to the film. The
/// first pass also draws the plain samples that the chains start from.
class MetropolisRenderer {
  public:
    MetropolisRenderer(const RenderContext& context, const PathTracer& tracer,
                       const MetropolisSettings& settings);

    /// Adds one pass to the film, or none as long as no plain sample has found light.
    PathCounts render_pass();
    /// One line for the log.
    std::string text() const;
    Statistics statistics() const;
    void state(StateArchive& archive);

  private:
    bool start(PathCounts& counts);
    std::vector<double> plain_brightness(PathCounts& counts) const;

    RenderContext context_;
    const PathTracer& tracer_;
    MetropolisSettings settings_;
    MetropolisPopulation population_;
    bool warned_ = false;
};

}  // namespace lxs
