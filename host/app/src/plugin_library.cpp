// Loads plugin modules and knows the integrators in them.
#include "lxs/host/plugin_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <system_error>

#include "lxs/host/failure.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& cause) {
    throw PluginFailure(fmt::format("plugin module '{}': {}", file.string(), cause));
}

std::vector<fs::path> modules_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".so") files.push_back(fs::canonical(entry.path(), error));
    }
    if (error) {
        throw PluginFailure(
            fmt::format("plugin folder '{}': {}", folder.string(), error.message()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Runs a function of a module; whatever it throws becomes a PluginFailure.
template <class Function>
auto call_module(const fs::path& file, std::string_view what, Function function) {
    try {
        return function();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        fail(file, fmt::format("{} failed: {}", what, error.what()));
    } catch (...) {
        fail(file, fmt::format("{} failed with an exception of unknown type", what));
    }
}

void check_module(const PluginModule* module, const fs::path& file) {
    if (module == nullptr) fail(file, "its entry function returned nothing");
    if (module->abi_version != kAbiVersion) {
        fail(file, fmt::format("built for version {} of the plugin SDK, but this lxsrender has "
                               "version {}; build the module again",
                               module->abi_version, kAbiVersion));
    }
    for (const IntegratorPlugin& plugin : module->integrators) {
        if (plugin.name.empty()) fail(file, "offers an integrator without a name");
        if (plugin.create == nullptr) {
            fail(file, fmt::format("integrator \"{}\" has no create function", plugin.name));
        }
    }
}

}  // namespace

/// A loaded shared library and what its entry function returned.
class PluginLibrary::Module {
  public:
    explicit Module(const fs::path& file) : file_(file) {
        std::error_code error;
        try {
            library_.load(file);
        } catch (const std::exception& cause) {
            fail(file, fmt::format("can't be loaded: {}", cause.what()));
        }
        if (!library_.has(kEntryName)) {
            fail(file, fmt::format("no plugin of lxsrender: it has no function {}", kEntryName));
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
    for (const IntegratorPlugin& plugin : module.description().integrators) {
        if (const LoadedIntegrator* other = find(plugin.name)) {
            fail(file, fmt::format("integrator \"{}\" is already offered by '{}'", plugin.name,
                                   other->file.string()));
        }
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
    const fs::path bin = boost::dll::program_location().parent_path();
    for (const char* relative : {LXS_INSTALLED_PLUGINS, LXS_BUILT_PLUGINS}) {
        fs::path folder = (bin / relative).lexically_normal();
        if (fs::is_directory(folder)) return folder;
    }
    return {};
}

std::unique_ptr<Integrator> create_integrator(const LoadedIntegrator& loaded,
                                              const ParameterReader& parameters) {
    const std::string what = fmt::format("creating integrator \"{}\"", loaded.plugin->name);
    auto integrator =
        call_module(loaded.file, what, [&] { return loaded.plugin->create(parameters); });
    if (!integrator) fail(loaded.file, what + " gave none");
    return integrator;
}

}  // namespace lxs
