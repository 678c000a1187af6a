// Prints what there is: `--list-plugins` and `--describe`.
#include "lxs/host/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/registry.h"

namespace lxs {
namespace {

/// Statements before WorldBegin whose plugins this host has itself.
constexpr std::array<const char*, 4> kOptionStatements = {"Camera", "Film", "PixelFilter",
                                                          "Sampler"};

/// A statement, a name that it knows, and the parameters of that.
struct Declared {
    std::string statement;
    std::string name;
    std::vector<ParameterDeclaration> parameters;
};

template <class Product>
void append(std::vector<Declared>& all, const char* statement,
            const std::map<std::string, Factory<Product>>& factories) {
    for (const auto& [name, factory] : factories)
        all.push_back({statement, name, factory.parameters});
}

void append_from_registry(std::vector<Declared>& all) {
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    append(all, "Shape", registry.shapes);
    append(all, "Material", registry.materials);
    append(all, "Volume", registry.media);
    append(all, "Texture float", registry.float_textures);
    append(all, "Texture color", registry.color_textures);
    append(all, "Texture fresnel", registry.fresnel_textures);
}

/// All that this host has itself: everything but integrators.
std::vector<Declared> own_declarations() {
    std::vector<Declared> all;
    append_from_registry(all);
    for (const char* statement : kOptionStatements) {
        for (const std::string& name : known_plugin_names().at(statement))
            all.push_back({statement, name, option_parameters(statement, name)});
    }
    for (const LightPlugin& light : light_plugins())
        all.push_back({"LightSource", light.name, light.parameters});
    const auto area = area_light_parameters();
    all.push_back({"AreaLightSource", "area", {area.begin(), area.end()}});
    return all;
}

/// What LuxRender calls a plugin of a statement that this program chooses by itself.
std::vector<Declared> chosen_by_itself() {
    std::vector<Declared> all;
    for (const char* statement :
         {"Accelerator", "PixelSampler", "Renderer", "ToneMap", "Volume", "VolumeIntegrator"}) {
        for (const std::string& name : known_plugin_names().at(statement))
            all.push_back({statement, name, {}});
    }
    return all;
}

/// Names by kind of statement.
std::map<std::string, std::vector<std::string>> names_by_kind(const PluginLibrary& plugins) {
    std::map<std::string, std::vector<std::string>> kinds{{"SurfaceIntegrator", plugins.names()}};
    for (const auto& some : {own_declarations(), chosen_by_itself()}) {
        for (const Declared& declared : some)
            kinds[declared.statement].push_back(declared.name);
    }
    return kinds;
}

std::string description(const Declared& declared, std::string_view doc, bool markdown) {
    std::string text =
        fmt::format("{}{} \"{}\"\n", markdown ? "## " : "", declared.statement, declared.name);
    if (!doc.empty()) text += fmt::format("{}\n", doc);
    text += '\n';
    if (declared.parameters.empty()) return text + "  no parameters are read\n";
    return text +
           (markdown ? describe_markdown(declared.parameters) : describe_text(declared.parameters));
}

}  // namespace

std::string list_plugins(const PluginLibrary& plugins) {
    std::string text;
    for (const LoadedIntegrator& loaded : plugins.integrators()) {
        text += fmt::format("{:<14} {}  [{}]\n", loaded.plugin->name, loaded.plugin->doc,
                            loaded.file.string());
    }
    return text;
}

std::string describe_plugin(const std::string& name, const PluginLibrary& plugins, bool markdown) {
    std::string text;
    if (const LoadedIntegrator* loaded = plugins.find(name)) {
        const auto& parameters = loaded->plugin->parameters;
        text = description({"SurfaceIntegrator", name, {parameters.begin(), parameters.end()}},
                           loaded->plugin->doc, markdown);
    }
    const auto add = [&](const std::vector<Declared>& some) {
        for (const Declared& declared : some) {
            if (declared.name == name) text += description(declared, "", markdown);
        }
    };
    add(own_declarations());
    if (text.empty()) add(chosen_by_itself());
    for (const auto& [statement, names] : known_plugin_names()) {
        if (text.empty() && std::find(names.begin(), names.end(), name) != names.end())
            text = fmt::format(
                "{} \"{}\"\n\n  LuxRender's, not rendered here: a warning says what "
                "stands in for it\n",
                statement, name);
    }
    for (const auto& [kind, names] : names_by_kind(plugins)) {
        if (kind == name || kind.starts_with(name + ' '))
            text += fmt::format("{}: {}\n", kind, fmt::join(names, ", "));
    }
    return text;
}

std::vector<std::string> described_kinds(const PluginLibrary& plugins) {
    std::vector<std::string> kinds;
    for (const auto& [kind, names] : names_by_kind(plugins))
        kinds.push_back(kind);
    return kinds;
}

std::vector<std::string> describable_names(const PluginLibrary& plugins) {
    std::vector<std::string> names = plugins.names();
    for (const auto& [kind, of_kind] : names_by_kind(plugins)) {
        names.push_back(kind);
        names.insert(names.end(), of_kind.begin(), of_kind.end());
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace lxs
