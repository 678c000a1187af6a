// Integrators that misbehave in ways that the host must survive.
#include <chrono>
#include <stdexcept>
#include <thread>

#include "lxs/sdk/plugin.h"

namespace {

/// A pass takes half a minute: time enough to interrupt it twice.
class Sleeper : public lxs::Integrator {
  public:
    void prepare(const lxs::RenderContext& context) override { context.log.info("sleeper: ready"); }
    lxs::PassReport render_pass(std::uint64_t /*pass*/) override {
        std::this_thread::sleep_for(std::chrono::seconds(30));
        return {};
    }
};

class Refuser : public lxs::Integrator {
  public:
    void prepare(const lxs::RenderContext& /*context*/) override {
        throw std::runtime_error("it only renders on Sundays");
    }
    lxs::PassReport render_pass(std::uint64_t /*pass*/) override { return {}; }
};

std::unique_ptr<lxs::Integrator> create_sleeper(const lxs::ParameterReader& /*parameters*/) {
    return std::make_unique<Sleeper>();
}
std::unique_ptr<lxs::Integrator> create_refuser(const lxs::ParameterReader& /*parameters*/) {
    return std::make_unique<Refuser>();
}
std::unique_ptr<lxs::Integrator> throw_in_create(const lxs::ParameterReader& /*parameters*/) {
    throw std::runtime_error("no such luck");
}
std::unique_ptr<lxs::Integrator> create_picky(const lxs::ParameterReader& parameters) {
    throw lxs::InputError(parameters.where(), "picky: takes no scene of yours");
}
std::unique_ptr<lxs::Integrator> create_none(const lxs::ParameterReader& /*parameters*/) {
    return {};
}

const lxs::IntegratorPlugin kPlugins[] = {
    {"sleeper", "Sleeps in each pass.", {}, &create_sleeper},
    {"refuser", "Refuses every scene.", {}, &create_refuser},
    {"throwing", "Throws when created.", {}, &throw_in_create},
    {"picky", "Finds fault with every parameter.", {}, &create_picky},
    {"absent", "Creates nothing.", {}, &create_none},
};

}  // namespace

LXS_PLUGIN_MODULE("troublesome", kPlugins)
