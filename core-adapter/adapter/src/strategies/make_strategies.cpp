// Which strategies carry light by a plan.
#include "strategies/emitter_strategy.h"
#include "strategies/photon_strategy.h"

namespace aips {

LightStrategies make_strategies(const Host& host, Plan& plan, std::uint32_t eye_paths) {
    LightStrategies strategies;
    strategies.push_back(std::make_unique<PhotonStrategy>(host, plan, eye_paths));
    if (plan.settings().guide_emitters)
        strategies.push_back(std::make_unique<EmitterStrategy>(host, eye_paths));
    return strategies;
}

}  // namespace aips
