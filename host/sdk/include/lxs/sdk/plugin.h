// Entry point of a plugin module.
//
//     static const lxs::IntegratorPlugin kPlugins[] = {{"mine", "one line", kParameters, &create}};
//     LXS_PLUGIN_MODULE("my-module", kPlugins)
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "lxs/sdk/integrator.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// Raised with every change of the SDK's headers that changes their binary layout.
inline constexpr std::uint32_t kAbiVersion = 21;

/// One surface integrator that a module offers.
struct IntegratorPlugin {
    std::string_view name;  ///< as in `SurfaceIntegrator "name"`
    std::string_view doc;   ///< one sentence
    std::span<const ParameterDeclaration> parameters;
    std::unique_ptr<Integrator> (*create)(const ParameterReader& parameters);
    /// Heeds Sampler::metropolis(); others get plain samples, and the user a warning.
    bool runs_metropolis = false;
};

/// What a module's entry function returns.
struct PluginModule {
    std::uint32_t abi_version;
    std::string_view name;
    std::span<const IntegratorPlugin> integrators;
};

/// Name of the entry function that the host looks up: `const PluginModule* lxs_plugin_module()`.
inline constexpr const char* kEntryName = "lxs_plugin_module";

}  // namespace lxs

/// Defines the entry function of a module.
#define LXS_PLUGIN_MODULE(module_name, plugins)                                        \
    extern "C" __attribute__((visibility("default"))) const lxs::PluginModule*         \
    lxs_plugin_module() {                                                              \
        static const lxs::PluginModule module{lxs::kAbiVersion, module_name, plugins}; \
        return &module;                                                                \
    }
