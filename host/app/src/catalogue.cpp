// Prints what there is: `--list-plugins` and `--describe`.
#include "lxs/host/catalogue.h"

#include <fmt/format.h>

#include "lxs/lights/lights.h"
#include "lxs/scene/registry.h"

namespace lxs {
namespace {

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

void add_from_registry(Description& description) {
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    description.add_from("Shape", registry.shapes);
    description.add_from("Material", registry.materials);
    description.add_from("Volume", registry.media);
    description.add_from("Texture float", registry.float_textures);
    description.add_from("Texture color", registry.color_textures);
    description.add_from("Texture fresnel", registry.fresnel_textures);
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
    for (const LightPlugin& light : light_plugins()) {
        if (light.name == name) description.add("LightSource", "", light.parameters);
    }
    if (name == "area") description.add("AreaLightSource", "", area_light_parameters());
    return description.text();
}

}  // namespace lxs
