// The integrator `path`: one sample a pixel and pass, rows in parallel, or Markov chains.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/metropolis_renderer.h"
#include "path/path_settings.h"
#include "path/path_tracer.h"
#include "path/random_stream.h"

namespace lxs {

/// Counts refused contributions by the name of the material where they arose.
class MaterialRefusals : public RefusalCounter {
  public:
    explicit MaterialRefusals(std::size_t materials) : counts_(materials + 1) {}

    void refuse(std::uint32_t material) override;
    std::uint64_t total() const;
    /// By material index; the last is for light from outside of all surfaces.
    std::uint64_t count(std::size_t index) const;
    void state(StateArchive& archive);

  private:
    std::vector<std::atomic<std::uint64_t>> counts_;
};

class PathIntegrator : public Integrator {
  public:
    explicit PathIntegrator(const PathSettings& settings) : settings_(settings) {}

    void prepare(const RenderContext& context) override;
    PassReport render_pass(std::uint64_t pass) override;
    Statistics statistics() const override;
    void state(StateArchive& archive) override;

  private:
    PathCounts render_pixels(std::uint64_t pass);
    PathCounts render_row(std::uint64_t pass, std::uint32_t y,
                          std::pmr::monotonic_buffer_resource& memory);
    void warn_of_refusals();

    PathSettings settings_;
    std::optional<RenderContext> context_;
    std::unique_ptr<MaterialRefusals> refusals_;
    std::optional<PathTracer> tracer_;
    std::vector<Vec2> positions_;  ///< of this pass, row by row
    std::vector<Rgb> radiance_;    ///< [pixel * light groups + group]
    PathCounts total_;
    std::optional<MetropolisRenderer> metropolis_;  ///< if the scene's sampler asks for it
    bool warned_ = false;
};

}  // namespace lxs
