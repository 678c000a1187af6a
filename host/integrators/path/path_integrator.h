// The integrator `path`: one sample a pixel and pass, rows in parallel.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "lxs/sdk/integrator.h"
#include "path/path_settings.h"
#include "path/path_tracer.h"

namespace lxs {

/// Counts refused contributions by the name of the material where they arose.
class MaterialRefusals : public RefusalCounter {
  public:
    explicit MaterialRefusals(std::size_t materials) : counts_(materials + 1) {}

    void refuse(std::uint32_t material) override;
    std::uint64_t total() const;
    /// By material index; the last is for light from outside of all surfaces.
    std::uint64_t count(std::size_t index) const;

  private:
    std::vector<std::atomic<std::uint64_t>> counts_;
};

class PathIntegrator : public Integrator {
  public:
    explicit PathIntegrator(const PathSettings& settings) : settings_(settings) {}

    void prepare(const RenderContext& context) override;
    PassReport render_pass(std::uint64_t pass) override;
    Statistics statistics() const override;

  private:
    struct Counts {
        std::uint64_t rays = 0;
        std::uint64_t bounces = 0;
    };

    Counts render_row(std::uint64_t pass, std::uint32_t y,
                      std::pmr::monotonic_buffer_resource& memory);
    void warn_of_refusals();

    PathSettings settings_;
    std::optional<RenderContext> context_;
    std::unique_ptr<MaterialRefusals> refusals_;
    std::optional<PathTracer> tracer_;
    std::vector<Vec2> positions_;  ///< of this pass, row by row
    std::vector<Rgb> radiance_;    ///< [pixel * light groups + group]
    std::uint64_t paths_ = 0;
    Counts total_;
    bool warned_ = false;
};

}  // namespace lxs
