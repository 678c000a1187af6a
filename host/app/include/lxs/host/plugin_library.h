// Loads plugin modules and knows the integrators in them.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/sdk/plugin.h"

namespace lxs {

/// An integrator and the module file that it came from.
struct LoadedIntegrator {
    const IntegratorPlugin* plugin = nullptr;
    std::filesystem::path file;
};

/// Owns the loaded modules: integrators made from them must not outlive it.
class PluginLibrary {
  public:
    PluginLibrary();
    ~PluginLibrary();
    PluginLibrary(const PluginLibrary&) = delete;
    PluginLibrary& operator=(const PluginLibrary&) = delete;

    /// Loads every module (*.so) of a folder, by name. A file of the same name in a folder loaded
    /// before hides this folder's, so that a module under work stands in for the installed one.
    /// Throws PluginFailure, also when another file offers a name that is already taken.
    void load_folder(const std::filesystem::path& folder);

    /// Null if no module offers this name.
    const LoadedIntegrator* find(std::string_view name) const;
    std::span<const LoadedIntegrator> integrators() const { return integrators_; }
    std::vector<std::string> names() const;

  private:
    class Module;

    void load(const std::filesystem::path& file);

    std::vector<Module> modules_;
    std::vector<LoadedIntegrator> integrators_;  ///< by name
};

/// Folder of the plugins that belong to this executable: in an installation lib/aips/plugins, in a
/// build tree plugins. Empty if there is neither.
std::filesystem::path own_plugin_folder();

/// Loads the modules of these folders, and those of this executable. Throws PluginFailure.
void load_plugins(std::span<const std::string> folders, PluginLibrary& plugins);

/// Makes the integrator; a failure that is no InputError becomes a PluginFailure.
std::unique_ptr<Integrator> create_integrator(const LoadedIntegrator& loaded,
                                              const ParameterReader& parameters);

}  // namespace lxs
