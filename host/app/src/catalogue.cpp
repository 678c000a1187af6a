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

/// Collects what is called `name`.
class Description {
  public:
    Description(std::string name, bool markdown) : name_(std::move(name)), markdown_(markdown) {}

    void add(std::string_view kind, std::string_view doc,
             std::span<const ParameterDeclaration> parameters) {
        text_ += fmt::format("{}{} \"{}\"\n", markdown_ ? "## " : "", kind, name_);
        if (!doc.empty()) text_ += fmt::format("{}\n", doc);
        text_ += '\n';
        text_ += markdown_ ? describe_markdown(parameters) : describe_text(parameters);
    }

    template <class Product>
    void add_from(std::string_view kind, const std::map<std::string, Factory<Product>>& factories) {
        const auto found = factories.find(name_);
        if (found != factories.end()) add(kind, "", found->second.parameters);
    }

    const std::string& text() const { return text_; }

  private:
    std::string name_;
    bool markdown_;
    std::string text_;
};

Registry own_registry() {
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    return registry;
}

void add_from_registry(Description& description) {
    const Registry registry = own_registry();
    description.add_from("Shape", registry.shapes);
    description.add_from("Material", registry.materials);
    description.add_from("Volume", registry.media);
    description.add_from("Texture float", registry.float_textures);
    description.add_from("Texture color", registry.color_textures);
    description.add_from("Texture fresnel", registry.fresnel_textures);
}

void add_from_options(const std::string& name, Description& description) {
    for (const char* statement : kOptionStatements) {
        const std::vector<std::string>& names = known_plugin_names().at(statement);
        if (std::find(names.begin(), names.end(), name) != names.end())
            description.add(statement, "", option_parameters(statement, name));
    }
}

template <class Product>
void append_names(std::vector<std::string>& names,
                  const std::map<std::string, Factory<Product>>& factories) {
    for (const auto& [name, factory] : factories)
        names.push_back(name);
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
    Description description(name, markdown);
    if (const LoadedIntegrator* loaded = plugins.find(name)) {
        description.add("SurfaceIntegrator", loaded->plugin->doc, loaded->plugin->parameters);
    }
    add_from_registry(description);
    add_from_options(name, description);
    for (const LightPlugin& light : light_plugins()) {
        if (light.name == name) description.add("LightSource", "", light.parameters);
    }
    if (name == "area") description.add("AreaLightSource", "", area_light_parameters());
    return description.text();
}

std::vector<std::string> describable_names(const PluginLibrary& plugins) {
    std::vector<std::string> names = plugins.names();
    const Registry registry = own_registry();
    append_names(names, registry.shapes);
    append_names(names, registry.materials);
    append_names(names, registry.media);
    append_names(names, registry.float_textures);
    append_names(names, registry.color_textures);
    append_names(names, registry.fresnel_textures);
    for (const char* statement : kOptionStatements) {
        const std::vector<std::string>& options = known_plugin_names().at(statement);
        names.insert(names.end(), options.begin(), options.end());
    }
    for (const LightPlugin& light : light_plugins())
        names.push_back(light.name);
    names.emplace_back("area");
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace lxs
