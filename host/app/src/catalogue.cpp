// Prints what there is: `--list-plugins` and `--describe`.
#include "lxs/host/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

std::string description(const Declared& declared, std::string_view doc, bool markdown) {
    std::string text =
        fmt::format("{}{} \"{}\"\n", markdown ? "## " : "", declared.statement, declared.name);
    if (!doc.empty()) text += fmt::format("{}\n", doc);
    text += '\n';
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
    for (const Declared& declared : own_declarations()) {
        if (declared.name == name) text += description(declared, "", markdown);
    }
    return text;
}

std::vector<std::string> describable_names(const PluginLibrary& plugins) {
    std::vector<std::string> names = plugins.names();
    for (const Declared& declared : own_declarations())
        names.push_back(declared.name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace lxs
