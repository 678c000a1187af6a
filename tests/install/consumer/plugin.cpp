// A plugin module built outside of the project, against the installed SDK.
#include <lxs/sdk/plugin.h>

namespace {

class BlackIntegrator : public lxs::Integrator {
  public:
    void prepare(const lxs::RenderContext& /*context*/) override {}
    lxs::PassReport render_pass(std::uint64_t /*pass*/) override { return {}; }
};

std::unique_ptr<lxs::Integrator> create(const lxs::ParameterReader& /*parameters*/) {
    return std::make_unique<BlackIntegrator>();
}

const lxs::IntegratorPlugin kPlugins[] = {{"consumer", "Renders nothing.", {}, &create}};

}  // namespace

LXS_PLUGIN_MODULE("consumer", kPlugins)
