// The engine: a plan, the strategies that it asks for, and the loop over passes.
#include "aips/adapter/engine.h"

#include "eye/eye_source.h"
#include "plan/plan.h"
#include "plan/skip_log.h"
#include "render/pass_loop.h"
#include "strategies/light_strategy.h"

namespace aips {

class Engine::State {
  public:
    State(const Host& host, const Settings& settings)
        : plan_(planned(host, settings)), loop_(make_loop(host)) {
        host.log.info("engine: " + describe(settings));
        host.log.info("plan: " + describe(plan_));
        host.log.info("engine memory: its settings bound it by " +
                      std::to_string((loop_.statistics().memory_bound_bytes >> 20) + 1) +
                      " MiB, whatever the scene makes of them");
        log_skipped(plan_.needs, host.log);
    }

    PassLoop& loop() { return loop_; }
    EngineStatistics statistics() const {
        EngineStatistics s = loop_.statistics();
        s.transport.skipped.insert(s.transport.skipped.begin(), plan_.needs.skipped.begin(),
                                   plan_.needs.skipped.end());
        return s;
    }

  private:
    static Plan planned(const Host& host, const Settings& settings) {
        Plan plan = make_plan(host.scene, settings);
        plan.fit_to(host.film);
        return plan;
    }
    PassLoop make_loop(const Host& host) {
        const std::uint32_t eye_paths = eye_paths_per_pass(
            plan_.settings(), std::uint64_t{host.film.width()} * host.film.height());
        return {host, plan_.settings(), eye_paths, plan_.needs.photons,
                make_strategies(host, plan_, eye_paths)};
    }

    Plan plan_;
    PassLoop loop_;
};

Engine::Engine(const Host& host, const Settings& settings) {
    validate(settings);
    state_ = std::make_unique<State>(host, settings);
}
Engine::~Engine() = default;
PassReport Engine::render_pass(std::uint64_t pass) {
    return state_->loop().render_pass(pass);
}
EngineStatistics Engine::statistics() const {
    return state_->statistics();
}
void Engine::state(StateArchive& archive) {
    state_->loop().state(archive);
}

void Engine::learned(StateArchive& archive) {
    state_->loop().learned(archive);
}

}  // namespace aips
