// The reference page of the scene language, from the declarations.
#include "lxs/host/scene_language_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>

#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/registry.h"

namespace lxs {
namespace {

using Declarations = std::optional<std::vector<ParameterDeclaration>>;

/// Rendered plugins by statement and name.
class Rendered {
  public:
    Rendered() {
        register_shapes(registry_);
        register_shading(registry_);
    }

    /// Declared parameters of what is rendered.
    Declarations of(const std::string& statement, const std::string& name) const;
    /// Names that only this renderer knows.
    std::set<std::string> names(const std::string& statement) const;

  private:
    template <class Visit>
    void visit(const std::string& statement, const Visit& visit) const;

    Registry registry_;
};

template <class Visit>
void Rendered::visit(const std::string& statement, const Visit& visit) const {
    if (statement == "Shape") visit(registry_.shapes);
    if (statement == "Material") visit(registry_.materials);
    if (statement == "MakeNamedVolume") visit(registry_.media);
    if (statement == "Texture float") visit(registry_.float_textures);
    if (statement == "Texture color") visit(registry_.color_textures);
    if (statement == "Texture fresnel") visit(registry_.fresnel_textures);
}

Declarations Rendered::of(const std::string& statement, const std::string& name) const {
    Declarations found;
    visit(statement, [&](const auto& factories) {
        const auto factory = factories.find(name);
        if (factory != factories.end()) found = factory->second.parameters;
    });
    if (statement == "LightSource") {
        for (const LightPlugin& light : light_plugins())
            if (light.name == name) found = light.parameters;
    }
    if (statement == "AreaLightSource") {
        const auto parameters = area_light_parameters();
        found.emplace(parameters.begin(), parameters.end());
    }
    auto options = option_parameters(statement, name);
    if (!options.empty()) found = std::move(options);
    return found;
}

std::set<std::string> Rendered::names(const std::string& statement) const {
    std::set<std::string> names;
    visit(statement, [&](const auto& factories) {
        for (const auto& [name, factory] : factories)
            names.insert(name);
    });
    return names;
}

/// What is used in place of a plugin that is not rendered; a located warning says it too.
std::string stand_in(const std::string& statement) {
    if (statement == "Material") return "matte with its Kd, or grey";
    if (statement == "Shape") return "nothing: it is left out";
    if (statement == "MakeNamedVolume") return "a clear volume with its index";
    if (statement == "Texture float") return "the constant 1";
    if (statement == "Texture color") return "a grey of 0.5";
    if (statement == "Texture fresnel") return "the index 1.5";
    return {};
}

/// Statements whose plugins are chosen by the program itself: no parameters to list.
bool is_listed(const std::string& statement) {
    return statement != "Accelerator" && statement != "PixelSampler" && statement != "Renderer" &&
           statement != "SurfaceIntegrator" && statement != "ToneMap" && statement != "Volume" &&
           statement != "VolumeIntegrator";
}

std::string section(const Rendered& rendered, const std::string& statement,
                    const std::vector<std::string>& known) {
    std::set<std::string> names = rendered.names(statement);
    names.insert(known.begin(), known.end());
    std::string text = fmt::format("## {}\n\n", statement);
    std::vector<std::string> missing;
    for (const std::string& name : names) {
        const Declarations declared = rendered.of(statement, name);
        if (!declared) {
            missing.push_back(name);
            continue;
        }
        text += fmt::format("### {} \"{}\"\n\n", statement, name);
        text += declared->empty() ? "No parameters.\n" : describe_markdown(*declared);
        text += '\n';
    }
    if (!missing.empty()) {
        text += fmt::format("Not rendered, with a located warning: {}. In their place: {}.\n\n",
                            fmt::join(missing, ", "), stand_in(statement));
    }
    return text;
}

}  // namespace

std::string scene_language_page() {
    const Rendered rendered;
    std::string text;
    for (const auto& [statement, names] : known_plugin_names()) {
        if (is_listed(statement)) text += section(rendered, statement, names);
    }
    return text;
}

}  // namespace lxs
