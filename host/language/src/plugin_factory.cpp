// Plugin look-up, stand-ins for what is not rendered.
#include "plugin_factory.h"

#include <fmt/format.h>

#include <algorithm>

#include "lxs/language/read_scene.h"
#include "lxs/scene/constant_texture.h"

namespace lxs {
namespace {

constexpr float kStandInGrey = 0.5f;

/// Another plugin with those of the given parameters that it shares.
ParameterSet with_plugin(const ParameterSet& set, const char* plugin, std::string_view shared) {
    ParameterSet result;
    result.plugin = plugin;
    result.where = set.where;
    for (const ParameterValue& value : set.values) {
        if (value.name == shared) result.values.push_back(value);
    }
    return result;
}

ParameterSet grey_matte(const ParameterSet& set) {
    ParameterSet matte = with_plugin(set, "matte", "Kd");
    if (matte.values.empty()) {
        matte.values.push_back(
            {"color", "Kd", std::vector<double>(3, kStandInGrey), set.where, {}});
    }
    return matte;
}

}  // namespace

template <class Product>
std::optional<Product> PluginFactory::make(
    const std::map<std::string, Factory<Product>>& registered, const Kind& kind,
    const ParameterSet& set, const Matrix& to_world) const {
    const auto found = registered.find(set.plugin);
    if (found != registered.end()) {
        const ParameterReader parameters(set, found->second.parameters, diagnostics_);
        return found->second.create(parameters, assets_, to_world);
    }
    std::vector<std::string> rendered;
    for (const auto& entry : registered)
        rendered.push_back(entry.first);
    report_missing(kind, set, rendered);
    return std::nullopt;
}

void PluginFactory::report_missing(const Kind& kind, const ParameterSet& set,
                                   const std::vector<std::string>& rendered) const {
    std::vector<std::string> known = known_plugin_names().at(kind.statement);
    if (std::find(known.begin(), known.end(), set.plugin) == known.end()) {
        known.insert(known.end(), rendered.begin(), rendered.end());
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        throw InputError(set.where, unknown_name_message(kind.noun, set.plugin, known));
    }
    diagnostics_.warning(set.where, fmt::format("{} \"{}\" is {}: {}", kind.noun, set.plugin,
                                                kind.state, kind.stand_in));
}

void PluginFactory::volume_region(const ParameterSet& set) const {
    report_missing({"volume region", "Volume", "it is left out", "not rendered"}, set, {});
}

std::optional<Geometry> PluginFactory::shape(const ParameterSet& set,
                                             const Matrix& to_world) const {
    try {
        return make(registry_.shapes, {"shape", "Shape", "it is skipped", "not supported"}, set,
                    to_world);
    } catch (const EmptyShape& empty) {
        diagnostics_.warning(empty.where(), empty.message() + "; the shape is skipped");
        return std::nullopt;
    }
}

std::shared_ptr<const Material> PluginFactory::material(const ParameterSet& set,
                                                        const Matrix& to_world) const {
    const Kind kind{"material", "Material", "matte with its Kd, or grey, is used instead"};
    const auto made = make(registry_.materials, kind, set, to_world);
    if (made) return *made;
    if (set.plugin == "matte") throw InputError(set.where, "no material \"matte\" is registered");
    return material(grey_matte(set), to_world);
}

SceneMedium PluginFactory::medium(const ParameterSet& set, const Matrix& to_world) const {
    const Kind kind{"volume", "MakeNamedVolume", "a clear one with its index is used instead"};
    const auto made = make(registry_.media, kind, set, to_world);
    if (made) return *made;
    if (set.plugin == "clear") return std::make_shared<Medium>(Rgb(0.0f), 1.0f);
    return medium(with_plugin(set, "clear", "fresnel"), to_world);
}

std::shared_ptr<const FloatTexture> PluginFactory::float_texture(const ParameterSet& set,
                                                                 const Matrix& to_world) const {
    const Kind kind{"float texture", "Texture float", "the constant 1 is used instead"};
    const auto made = make(registry_.float_textures, kind, set, to_world);
    return made ? *made : std::make_shared<ConstantTexture<float>>(1.0f);
}

std::shared_ptr<const ColorTexture> PluginFactory::color_texture(const ParameterSet& set,
                                                                 const Matrix& to_world) const {
    const Kind kind{"color texture", "Texture color", "a grey of 0.5 is used instead"};
    const auto made = make(registry_.color_textures, kind, set, to_world);
    return made ? *made : std::make_shared<ConstantTexture<Rgb>>(Rgb(kStandInGrey));
}

std::shared_ptr<const FresnelTexture> PluginFactory::fresnel_texture(const ParameterSet& set,
                                                                     const Matrix& to_world) const {
    const Kind kind{"fresnel texture", "Texture fresnel", "the index 1.5 is used instead"};
    const auto made = make(registry_.fresnel_textures, kind, set, to_world);
    return made ? *made : std::make_shared<ConstantTexture<FresnelValue>>(FresnelValue{});
}

}  // namespace lxs
