// LuxRender's Renderer and SurfaceIntegrator "aips".
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "lux_headers.h"
#include "renderer.h"
#include "transport.h"

#include "engine_run.h"
#include "lux_statistics.h"
#include "scene_view.h"

namespace aips::luxrender {

/// Carries the parameters; the renderer does the rest.
class LuxIntegrator final : public lux::SurfaceIntegrator {
  public:
    explicit LuxIntegrator(const std::vector<GivenParameter>& given) : given_(given) {}
    const std::vector<GivenParameter>& given() const { return given_; }
    /// Called by other renderers alone, which cannot render by it: ends the render with a message.
    void Preprocess(const lux::RandomGenerator&, const lux::Scene&) override;
    unsigned Li(const lux::Scene&, const lux::Sample&) const override { return 0; }

    static lux::SurfaceIntegrator* CreateSurfaceIntegrator(const lux::ParamSet& parameters);

  private:
    std::vector<GivenParameter> given_;
};

/// Renders in the thread that calls Render(), with as many more as LuxRender asks for.
class LuxRenderer final : public lux::Renderer {
  public:
    LuxRenderer();
    ~LuxRenderer() override;

    /// There is no type for renderers that LuxRender doesn't know; this one's is asked for by
    /// nobody but the interface's list of devices.
    RendererType GetType() const override { return SAMPLER_TYPE; }
    RendererState GetState() const override { return state_; }
    std::vector<lux::RendererHostDescription*>& GetHostDescs() override { return hosts_; }
    void SuspendWhenDone(bool suspend) override { suspend_when_done_ = suspend; }
    void Render(lux::Scene* scene) override;
    void Pause() override;
    void Resume() override;
    void Terminate() override { state_ = TERMINATE; }

    static lux::Renderer* CreateRenderer(const lux::ParamSet& parameters);

  private:
    class Device;
    class Machine;

    /// Why the scene cannot be rendered; empty if it can.
    std::string refusal(lux::Scene& scene) const;
    /// Ends the render with a message; images of earlier renders stay as they are.
    void refuse(lux::Scene& scene, const std::string& why);
    void render_passes(lux::Scene& scene, EngineRun& run);
    /// Waits while paused; false if the render is over.
    bool goes_on();
    /// False, and no change, if the state is another: other threads may have ended the render.
    bool change_state(RendererState from, RendererState to);

    std::atomic<RendererState> state_{INIT};
    std::atomic<bool> suspend_when_done_{false};
    std::unique_ptr<LuxStatistics> statistics_;
    std::unique_ptr<Machine> machine_;
    std::vector<lux::RendererHostDescription*> hosts_;
};

}  // namespace aips::luxrender
