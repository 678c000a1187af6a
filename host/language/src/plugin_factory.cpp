// Plugin look-up, and what LuxRender uses where there is no such plugin or it can't be made.
#include "plugin_factory.h"

#include <fmt/format.h>

#include <algorithm>

#include "lxs/language/read_scene.h"

namespace lxs {
template <class Product>
std::optional<Product> PluginFactory::make(
    const std::map<std::string, Factory<Product>>& registered, const Kind& kind,
    const ParameterSet& set, const Matrix& to_world) const {
    const auto found = registered.find(set.plugin);
    if (found == registered.end()) {
        std::vector<std::string> rendered;
        rendered.reserve(registered.size());
        for (const auto& entry : registered)
            rendered.push_back(entry.first);
        report_missing(kind, set, rendered);
        return std::nullopt;
    }
    try {
        const ParameterReader parameters(set, found->second.parameters, diagnostics_);
        return found->second.create(parameters, assets_, to_world);
    } catch (const EmptyShape&) {
        throw;
    } catch (const EndOfReading&) {
        throw;
    } catch (const InputError& error) {
        diagnostics_.fallback(error.where(), error.message(), kind.instead);
        return std::nullopt;
    }
}

void PluginFactory::report_missing(const Kind& kind, const ParameterSet& set,
                                   const std::vector<std::string>& rendered) const {
    std::vector<std::string> known = known_plugin_names().at(kind.statement);
    if (std::find(known.begin(), known.end(), set.plugin) == known.end()) {
        known.insert(known.end(), rendered.begin(), rendered.end());
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        diagnostics_.fallback(set.where, unknown_name_message(kind.noun, set.plugin, known),
                              kind.instead);
        return;
    }
    diagnostics_.warning(set.where, fmt::format("{} \"{}\" is {}: {}", kind.noun, set.plugin,
                                                kind.state, kind.instead));
}

void PluginFactory::volume_region(const ParameterSet& set) const {
    report_missing({"volume region", "Volume", "it is left out", "not rendered"}, set, {});
}

std::optional<Geometry> PluginFactory::shape(const ParameterSet& set,
                                             const Matrix& to_world) const {
    try {
        return make(registry_.shapes, {"shape", "Shape", "the shape is skipped", "not supported"},
                    set, to_world);
    } catch (const EmptyShape& empty) {
        diagnostics_.warning(empty.where(), empty.message() + "; the shape is skipped");
        return std::nullopt;
    }
}

std::shared_ptr<const Material> PluginFactory::material(const ParameterSet& set,
                                                        const Matrix& to_world) const {
    const Kind kind{"material", "Material", "matte with its defaults is used"};
    const auto made = make(registry_.materials, kind, set, to_world);
    if (made) return *made;
    if (set.plugin == "matte") throw InputError(set.where, "no material \"matte\" is registered");
    ParameterSet matte;
    matte.plugin = "matte";
    matte.where = set.where;
    return material(matte, to_world);
}

std::optional<SceneMedium> PluginFactory::medium(const ParameterSet& set,
                                                 const Matrix& to_world) const {
    const Kind kind{"volume", "MakeNamedVolume", "there is none of this name"};
    return make(registry_.media, kind, set, to_world);
}

template <class Texture>
std::shared_ptr<const Texture> PluginFactory::texture(
    const std::map<std::string, Factory<std::shared_ptr<const Texture>>>& registered,
    const char* noun, const char* statement, const ParameterSet& set,
    const Matrix& to_world) const {
    const Kind kind{noun, statement, "parameters that name it keep their defaults"};
    const auto made = make(registered, kind, set, to_world);
    return made ? *made : nullptr;
}

std::shared_ptr<const FloatTexture> PluginFactory::float_texture(const ParameterSet& set,
                                                                 const Matrix& to_world) const {
    return texture(registry_.float_textures, "float texture", "Texture float", set, to_world);
}

std::shared_ptr<const ColorTexture> PluginFactory::color_texture(const ParameterSet& set,
                                                                 const Matrix& to_world) const {
    return texture(registry_.color_textures, "color texture", "Texture color", set, to_world);
}

std::shared_ptr<const FresnelTexture> PluginFactory::fresnel_texture(const ParameterSet& set,
                                                                     const Matrix& to_world) const {
    return texture(registry_.fresnel_textures, "fresnel texture", "Texture fresnel", set, to_world);
}

}  // namespace lxs
