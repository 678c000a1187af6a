// Registration of `aips` and of the baselines it is measured against.
#include <stdexcept>

#include "engine_integrator.h"
#include "lxs/sdk/plugin.h"
#include "parameters.h"

namespace {

template <aips::PluginKind kind>
std::unique_ptr<lxs::Integrator> create(const lxs::ParameterReader& parameters) {
    const aips::Settings settings = aips::read_settings(kind, parameters);
    try {
        aips::validate(settings);
    } catch (const std::invalid_argument& error) {
        throw lxs::InputError(parameters.where(), error.what());
    }
    return std::make_unique<aips::shim::EngineIntegrator>(settings);
}

const lxs::IntegratorPlugin kPlugins[] = {
    {"aips", "Adaptive importance photon shooting (Liu and Zheng 2014).",
     aips::parameter_declarations(aips::PluginKind::Aips), &create<aips::PluginKind::Aips>},
    {"sppm", "Stochastic progressive photon mapping, unguided: the baseline.",
     aips::parameter_declarations(aips::PluginKind::Sppm), &create<aips::PluginKind::Sppm>},
    {"ppm", "Progressive photon mapping with fixed hit points, unguided: the baseline.",
     aips::parameter_declarations(aips::PluginKind::Ppm), &create<aips::PluginKind::Ppm>},
    {"exphotonmap", "Photon mapping with a fixed radius, unguided: the baseline.",
     aips::parameter_declarations(aips::PluginKind::ExPhotonMap),
     &create<aips::PluginKind::ExPhotonMap>},
};

}  // namespace

LXS_PLUGIN_MODULE("aips", kPlugins)
