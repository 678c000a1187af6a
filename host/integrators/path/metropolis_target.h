// An eye path as a function of its point in primary sample space.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <utility>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/metropolis_chain.h"
#include "path/path_tracer.h"

namespace lxs {

/// Traces the eye path that starts anywhere on the film: dimensions 0 and 1 are the place on the
/// film, 2 and 3 on the lens, 4 the time, the others as the path asks for them. Brightness is the
/// luminance of all light groups. For use by one thread.
class PathTarget final : public MetropolisTarget {
  public:
    /// `told` takes what the first shadow rays of all paths find; null: nothing does.
    PathTarget(const RenderContext& context, const PathTracer& tracer,
               std::vector<aips::LightSample>* told = nullptr);

    void evaluate(PrimarySample& sample, Contribution& contribution) override;

    /// What was traced since the last call.
    PathCounts take_counts() { return std::exchange(counts_, {}); }

  private:
    const RenderContext& context_;
    const PathTracer& tracer_;
    std::vector<aips::LightSample>* told_;
    std::vector<std::byte> buffer_;
    std::pmr::monotonic_buffer_resource memory_;
    PathCounts counts_;
};

}  // namespace lxs
