// The integrator `path`: one sample a pixel and pass, rows in parallel, or Markov chains.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/metropolis_renderer.h"
#include "path/path_settings.h"
#include "path/path_tracer.h"
#include "path/random_stream.h"

namespace lxs {

class PathIntegrator : public Integrator {
  public:
    explicit PathIntegrator(const PathSettings& settings) : settings_(settings) {}

    void prepare(const RenderContext& context) override;
    PassReport render_pass(std::uint64_t pass) override;
    Statistics statistics() const override;
    void state(StateArchive& archive) override;
    void learned(StateArchive& archive) override;
    InvalidSampleList invalid_samples() const override;

  private:
    void resize_pixels();
    PathCounts render_pixels(std::uint64_t pass);
    /// One path a pixel, into the members below.
    PathCounts trace_pixels(std::uint64_t pass);
    PathCounts render_row(std::uint64_t pass, std::uint32_t y,
                          std::pmr::monotonic_buffer_resource& memory);
    void learn_lights(std::uint64_t pass);

    PathSettings settings_;
    std::optional<RenderContext> context_;
    std::optional<PathSampleFilter> filter_;
    std::optional<PathTracer> tracer_;
    std::vector<Vec2> positions_;    ///< of this pass, row by row
    std::vector<Rgb> radiance_;      ///< [pixel * light groups + group]
    std::vector<Rgb> parts_;         ///< [pixel * kImageParts + ImagePart]; empty if not wanted
    std::vector<SeenSurface> seen_;  ///< [pixel]; empty if not wanted
    std::vector<std::vector<aips::LightSample>> told_;  ///< by the rows of this pass
    PathCounts total_;
    std::optional<MetropolisRenderer> metropolis_;  ///< if the scene's sampler asks for it
};

}  // namespace lxs
