// Which integrator renders a scene, and with which parameters.
#include "lxs/host/integrator_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "lxs/host/parameter_override.h"
#include "lxs/language/read_scene.h"
#include "lxs/pbrt/read_pbrt.h"

namespace lxs {
namespace {

/// LuxRender's integrator where a scene names none.
constexpr std::string_view kDefaultIntegrator = "path";
/// Renderer names that say the same as a SurfaceIntegrator of that name.
constexpr std::array<std::string_view, 2> kPhotonRenderers = {"aips", "sppm"};
/// Integrators that these renderers may run.
constexpr std::array<std::string_view, 4> kPhotonIntegrators = {"aips", "exphotonmap", "ppm",
                                                                "sppm"};

/// Integrators of LuxRender's, of 1.9 and before, that have no plugin of their own.
constexpr std::array<std::string_view, 7> kRenderedByDefault = {
    "bidirectional",  "directlighting", "distributedpath", "igi",
    "importancepath", "mltpath",        "particletracing"};

/// Renderers of LuxRender 1.0 to 1.6, and the nearest that 1.9 and we have.
struct OlderRenderer {
    std::string_view name, nearest;
};
constexpr std::array<OlderRenderer, 5> kOlderRenderers{{{"hybrid", "sampler"},
                                                        {"hybridsampler", "sampler"},
                                                        {"hybridsppm", "sppm"},
                                                        {"luxcore", "sampler"},
                                                        {"slg", "sampler"}}};

bool contains(auto&& names, std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

const ParameterSet* statement(const SceneContents& contents, const std::string& name) {
    const auto found = contents.options.find(name);
    return found == contents.options.end() ? nullptr : &found->second.parameters;
}

/// What is wrong with the name in a statement that changes nothing here: nothing if LuxRender knows
/// it.
std::optional<InputError> wrong_name(const SceneContents& contents, const std::string& kind,
                                     std::span<const std::string_view> also_known = {}) {
    const ParameterSet* set = statement(contents, kind);
    if (set == nullptr) return std::nullopt;
    std::vector<std::string> known(also_known.begin(), also_known.end());
    const auto table = known_plugin_names().find(kind);
    if (table != known_plugin_names().end()) {
        known.insert(known.end(), table->second.begin(), table->second.end());
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    if (contains(known, set->plugin)) return std::nullopt;
    return InputError(set->where, unknown_name_message(kind, set->plugin, known));
}

/// One warning for all parameters of a statement of which only the name is looked at.
void warn_of_parameters(const SceneContents& contents, const std::string& kind,
                        std::string_view reason, Diagnostics& diagnostics) {
    const ParameterSet* set = statement(contents, kind);
    if (set == nullptr || set->values.empty()) return;
    diagnostics.warning(set->values.front().where,
                        fmt::format("parameters of {} have no effect: {}", kind, reason));
}

void check_statements_by_name(const SceneContents& contents, Diagnostics& diagnostics) {
    if (const auto wrong = wrong_name(contents, "Renderer", kPhotonRenderers))
        diagnostics.error(*wrong);
    warn_of_parameters(contents, "Renderer", "the integrator decides", diagnostics);
    if (const auto wrong = wrong_name(contents, "VolumeIntegrator")) diagnostics.error(*wrong);
    warn_of_parameters(contents, "VolumeIntegrator", "flights through media need no steps",
                       diagnostics);
    if (const auto wrong = wrong_name(contents, "Accelerator"))
        diagnostics.fallback(wrong->where(), wrong->message(), "Embree traces all the same");
    warn_of_parameters(contents, "Accelerator", "Embree builds the tree", diagnostics);
}

/// What a scene's Renderer statement asks for.
struct RendererChoice {
    std::string given, used;  ///< its name, and the nearest in place of an older one
    SourceLocation where;
};

/// The Renderer statement; that another stands in for an older one is said.
std::optional<RendererChoice> renderer_of(const SceneContents& contents, Diagnostics& diagnostics) {
    const ParameterSet* given = statement(contents, "Renderer");
    if (given == nullptr) return std::nullopt;
    RendererChoice renderer{given->plugin, given->plugin, given->where};
    for (const OlderRenderer& older : kOlderRenderers) {
        if (older.name != given->plugin) continue;
        renderer.used = older.nearest;
        diagnostics.fallback(given->where,
                             fmt::format("Renderer \"{}\" is not rendered", given->plugin),
                             fmt::format("\"{}\" is used instead", older.nearest));
    }
    return renderer;
}

/// What the scene asks for, whether or not there is such a plugin.
ParameterSet scene_choice(const SceneContents& contents, Diagnostics& diagnostics) {
    const std::optional<RendererChoice> renderer = renderer_of(contents, diagnostics);
    const bool photon_renderer = renderer.has_value() && contains(kPhotonRenderers, renderer->used);
    if (const ParameterSet* set = statement(contents, "SurfaceIntegrator")) {
        if (photon_renderer && !contains(kPhotonIntegrators, set->plugin)) {
            diagnostics.warning(renderer->where, fmt::format("Renderer \"{}\" has no effect with "
                                                             "SurfaceIntegrator \"{}\"",
                                                             renderer->given, set->plugin));
        }
        return *set;
    }
    ParameterSet set;
    set.plugin = photon_renderer ? renderer->used : kDefaultIntegrator;
    set.where = photon_renderer ? renderer->where : contents.end;
    return set;
}

/// Whether `set` names an integrator whose place the default one takes, which is then said.
bool stands_in(ParameterSet& set, Diagnostics& diagnostics) {
    if (!contains(kRenderedByDefault, set.plugin)) return false;
    diagnostics.fallback(set.where,
                         fmt::format("SurfaceIntegrator \"{}\" is not rendered", set.plugin),
                         fmt::format("\"{}\" is used instead; \"aips\" (--integrator aips) shoots "
                                     "photons too",
                                     kDefaultIntegrator));
    set.plugin = kDefaultIntegrator;
    return true;
}

/// Leaves out the parameters that `plugin` doesn't declare. `asked_for`: by the command line;
/// where it stands in for the scene's choice that is warned of.
void keep_declared(const IntegratorPlugin& plugin, ParameterSet& set, bool asked_for,
                   Diagnostics& diagnostics, Log& log) {
    std::vector<std::string> dropped;
    SourceLocation where;
    std::erase_if(set.values, [&](const ParameterValue& value) {
        const bool declared =
            std::any_of(plugin.parameters.begin(), plugin.parameters.end(),
                        [&](const auto& declaration) { return declaration.name == value.name; });
        if (!declared && dropped.empty()) where = value.where;
        if (!declared) dropped.push_back(value.name);
        return !declared;
    });
    if (dropped.empty()) return;
    if (!asked_for) {
        diagnostics.warning(where, fmt::format("parameters without effect with \"{}\": {}",
                                               plugin.name, fmt::join(dropped, ", ")));
    } else {
        log.info(fmt::format("the scene's parameters unknown to \"{}\" are left out: {}",
                             plugin.name, fmt::join(dropped, ", ")));
    }
}

/// A scene of pbrt that asks for its sppm says how that begins; another integrator finds its own
/// radius and number of photons.
void forget_pbrts_start(ParameterSet& set, const SourceLocation& where) {
    if (where.file == nullptr || !is_pbrt_file(where.file->name)) return;
    std::erase_if(set.values, [](const ParameterValue& value) {
        return value.name == "startradius" || value.name == "photonperpass";
    });
}

}  // namespace

IntegratorChoice choose_integrator(const CommandLine& command, const SceneContents& contents,
                                   const PluginLibrary& plugins, Diagnostics& diagnostics,
                                   Log& log) {
    check_statements_by_name(contents, diagnostics);
    IntegratorChoice choice;
    choice.parameters = scene_choice(contents, diagnostics);
    const std::string named = choice.parameters.plugin;
    const SourceLocation named_at = choice.parameters.where;
    choice.of_luxrender = contains(known_plugin_names().at("SurfaceIntegrator"), named) ||
                          contains(kRenderedByDefault, named);
    if (command.integrator) {
        choice.parameters.plugin = *command.integrator;
        choice.parameters.where = command_line_location("--integrator " + *command.integrator);
    }
    choice.integrator = plugins.find(choice.parameters.plugin);
    if (choice.integrator == nullptr && stands_in(choice.parameters, diagnostics)) {
        choice.integrator = plugins.find(kDefaultIntegrator);
    }
    if (choice.integrator == nullptr) {
        throw InputError(
            choice.parameters.where,
            unknown_name_message("SurfaceIntegrator", choice.parameters.plugin, plugins.names()));
    }
    if (choice.parameters.plugin != named) {
        forget_pbrts_start(choice.parameters, named_at);
        keep_declared(*choice.integrator->plugin, choice.parameters, command.integrator.has_value(),
                      diagnostics, log);
    }
    apply_overrides(command.overrides, plugins, choice.parameters, log);
    return choice;
}

}  // namespace lxs
