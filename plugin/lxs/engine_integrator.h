// The engine as a surface integrator of the host.
#pragma once

#include <memory>
#include <optional>

#include "aips/adapter/engine.h"
#include "lxs/sdk/integrator.h"
#include "ranks_shim.h"
#include "scene_shim.h"

namespace aips::shim {

class EngineIntegrator final : public lxs::Integrator {
  public:
    explicit EngineIntegrator(const Settings& settings) : settings_(settings) {}

    void prepare(const lxs::RenderContext& context) override;
    lxs::PassReport render_pass(std::uint64_t pass) override;
    bool passes_stand_alone() const override { return settings_.mode == Mode::Progressive; }
    bool shares_passes() const override { return true; }
    lxs::Statistics statistics() const override;
    lxs::InvalidSampleList invalid_samples() const override;
    lxs::TransportStatistics transport_statistics() const override;
    void state(lxs::StateArchive& archive) override;
    void learned(lxs::StateArchive& archive) override;

  private:
    /// The host's parts in the engine's terms; they live as long as the engine.
    struct Shims {
        explicit Shims(const lxs::RenderContext& context)
            : scene(context.scene),
              camera(context.camera),
              sampler(context.sampler),
              film(context.film),
              log(context.log) {
            if (context.ranks) ranks.emplace(*context.ranks);
        }

        SceneShim scene;
        CameraShim camera;
        SamplerShim sampler;
        FilmShim film;
        LogShim log;
        std::optional<RanksShim> ranks;
    };

    Settings settings_;
    std::unique_ptr<Shims> shims_;
    std::unique_ptr<Engine> engine_;
    double pixels_ = 1;
};

}  // namespace aips::shim
