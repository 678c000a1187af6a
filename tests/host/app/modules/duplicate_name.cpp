// A module that offers an integrator name that is already taken.
#include "lxs/sdk/plugin.h"

namespace {

std::unique_ptr<lxs::Integrator> create(const lxs::ParameterReader& /*parameters*/) {
    return {};
}
const lxs::IntegratorPlugin kPlugins[] = {{"path", "Another path tracer.", {}, &create}};

}  // namespace

LXS_PLUGIN_MODULE("duplicate", kPlugins)
