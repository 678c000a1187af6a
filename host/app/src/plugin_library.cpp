// Loads plugin modules and knows the integrators in them.
#include "lxs/host/plugin_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "guarded_integrator.h"
#include "lxs/host/plugin_check.h"
#include "lxs/modules/load_module.h"
#include "lxs/modules/module_file.h"
#include "plugin_call.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> modules_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".so") continue;
        std::error_code no_file;
        files.push_back(fs::canonical(entry.path(), no_file));
        if (no_file) fail_module(entry.path(), no_file.message());
    }
    if (error) {
        throw PluginFailure(
            fmt::format("plugin folder '{}': {}", folder.string(), error.message()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

/// A loaded shared library and what its entry function returned.
class PluginLibrary::Module {
  public:
    explicit Module(const fs::path& file) : file_(file) {
        std::error_code error;
        try {
            load_module(library_, file);
        } catch (const std::exception& cause) {
            fail_module(file, fmt::format("can't be loaded: {}", cause.what()));
        }
        if (!library_.has(kEntryName)) {
            fail_module(file,
                        fmt::format("no plugin of lxsrender: it has no function {}", kEntryName));
        }
        description_ = call_module(file, "its entry function", [this] {
            return library_.get<const PluginModule*()>(kEntryName)();
        });
        check_module(description_, file);
    }

    const fs::path& file() const { return file_; }
    const PluginModule& description() const { return *description_; }

  private:
    fs::path file_;
    boost::dll::shared_library library_;
    const PluginModule* description_ = nullptr;
};

PluginLibrary::PluginLibrary() = default;
PluginLibrary::~PluginLibrary() = default;

void PluginLibrary::load_folder(const fs::path& folder) {
    for (const fs::path& file : modules_in(folder)) {
        const bool shadowed = std::any_of(
            modules_.begin(), modules_.end(),
            [&](const Module& module) { return module.file().filename() == file.filename(); });
        if (!shadowed) load(file);
    }
}

void PluginLibrary::load(const fs::path& file) {
    Module module(file);
    // All or none: what is in the list must not outlive the module.
    for (const IntegratorPlugin& plugin : module.description().integrators) {
        if (const LoadedIntegrator* other = find(plugin.name)) {
            fail_module(file, fmt::format("integrator \"{}\" is already offered by '{}'",
                                          plugin.name, other->file.string()));
        }
    }
    for (const IntegratorPlugin& plugin : module.description().integrators) {
        const auto place = std::upper_bound(
            integrators_.begin(), integrators_.end(), plugin.name,
            [](std::string_view name, const auto& known) { return name < known.plugin->name; });
        integrators_.insert(place, {&plugin, file});
    }
    modules_.push_back(std::move(module));
}

const LoadedIntegrator* PluginLibrary::find(std::string_view name) const {
    for (const LoadedIntegrator& loaded : integrators_) {
        if (loaded.plugin->name == name) return &loaded;
    }
    return nullptr;
}

std::vector<std::string> PluginLibrary::names() const {
    std::vector<std::string> names;
    for (const LoadedIntegrator& loaded : integrators_)
        names.emplace_back(loaded.plugin->name);
    return names;
}

fs::path own_plugin_folder() {
    return beside_program({LXS_INSTALLED_PLUGINS, LXS_BUILT_PLUGINS});
}

void load_plugins(std::span<const std::string> folders, PluginLibrary& plugins) {
    for (const std::string& folder : folders)
        plugins.load_folder(folder);
    const fs::path own = own_plugin_folder();
    if (!own.empty()) plugins.load_folder(own);
}

std::unique_ptr<Integrator> create_integrator(const LoadedIntegrator& loaded,
                                              const ParameterReader& parameters) {
    const std::string what = fmt::format("creating integrator \"{}\"", loaded.plugin->name);
    auto integrator =
        call_module(loaded.file, what, [&] { return loaded.plugin->create(parameters); });
    if (!integrator) fail_module(loaded.file, what + " gave none");
    return guarded(std::move(integrator), std::string(loaded.plugin->name), loaded.file);
}

}  // namespace lxs
