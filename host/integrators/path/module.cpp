// Plugin module of the host's reference integrator.
#include "lxs/sdk/plugin.h"
#include "path/path_integrator.h"

namespace {

std::unique_ptr<lxs::Integrator> create_path(const lxs::ParameterReader& parameters) {
    return std::make_unique<lxs::PathIntegrator>(lxs::PathSettings::read(parameters));
}

std::span<const lxs::IntegratorPlugin> plugins() {
    static const lxs::IntegratorPlugin list[] = {
        {"path",
         "Path tracing with next-event estimation and multiple importance sampling; Markov "
         "chains under Sampler \"metropolis\".",
         lxs::PathSettings::declarations(), &create_path, true}};
    return list;
}

}  // namespace

LXS_PLUGIN_MODULE("lxs-path", plugins())
