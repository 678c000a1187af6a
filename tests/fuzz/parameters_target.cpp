// Fuzz target: declared parameters of every registered plugin with arbitrary values: types, lists,
// ranges, unknown names. What is made is used once, so that a value which only hurts later does.
// The first bytes choose the plugin, the rest its parameters.
#include <functional>

#include "fuzz_target.h"
#include "input_bytes.h"
#include "input_files.h"
#include "plugin_uses.h"

namespace {

using fuzz::InputBytes;
using lxs::ParameterDeclaration;
using lxs::ParameterType;

std::string written_type(ParameterType declared, InputBytes& input) {
    constexpr std::array<const char*, 11> kTypes = {"float",   "integer", "bool",   "string",
                                                    "color",   "point",   "vector", "normal",
                                                    "texture", "rgb",     "odd"};
    if (input.below(8) == 7) return kTypes[input.below(kTypes.size())];
    switch (declared) {
        case ParameterType::FloatTexture:
            return input.below(4) == 3 ? "texture" : "float";
        case ParameterType::ColorTexture:
            return input.below(4) == 3 ? "texture" : "color";
        case ParameterType::FresnelTexture:
            return input.below(4) == 3 ? "float" : "texture";
        default:
            return kTypes[std::array{0u, 1u, 2u, 3u, 4u, 5u, 6u,
                                     7u}[static_cast<std::size_t>(declared)]];
    }
}

std::vector<double> numbers(std::size_t count, InputBytes& input) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(input.number());
    return values;
}

std::string string_of(const ParameterDeclaration& declared, InputBytes& input) {
    constexpr std::array<const char*, 6> kFiles = {"mesh.ply", "mesh.stl",  "lamp.ies",
                                                   "metal.nk", "light.spd", "image.png"};
    const std::size_t kind = input.below(8);
    if (kind < 6 && !declared.choices.empty())
        return std::string(declared.choices[input.below(declared.choices.size())]);
    if (kind < 6) return kFiles[input.below(kFiles.size())];
    return input.text(24);
}

lxs::ParameterValue value_of(const ParameterDeclaration& declared, InputBytes& input) {
    lxs::ParameterValue value;
    value.name = declared.name;
    value.type = written_type(declared.type, input);
    value.where = fuzz::somewhere();
    const bool triple = value.type != "float" && value.type != "integer" && value.type != "string";
    const std::size_t usual = triple ? 3 : 1;
    const std::size_t kind = input.below(16);
    std::size_t count = declared.array ? input.below(13) * usual : usual;
    if (kind == 15) count = input.below(8);
    if (value.type == "bool" && kind < 14) {
        value.values = std::vector<bool>(kind == 13 ? count : 1, input.below(2) == 1);
    } else if (value.type == "string" || value.type == "texture" || kind == 14) {
        std::vector<std::string> strings(kind == 15 ? count : 1);
        for (std::string& text : strings)
            text = string_of(declared, input);
        value.values = std::move(strings);
    } else {
        value.values = numbers(count, input);
    }
    return value;
}

lxs::ParameterSet parameters_of(const fuzz::PluginUse& plugin, InputBytes& input) {
    lxs::ParameterSet set;
    set.plugin = plugin.name;
    set.where = fuzz::somewhere();
    constexpr std::size_t kMost = 32;
    while (!input.empty() && set.values.size() < kMost) {
        if (plugin.declared.empty() || input.below(64) == 63) {
            ParameterDeclaration unknown;
            const std::string name = input.text(12);
            unknown.name = name;
            set.values.push_back(value_of(unknown, input));
        } else {
            set.values.push_back(
                value_of(plugin.declared[input.below(plugin.declared.size())], input));
        }
    }
    return set;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::vector<fuzz::PluginUse> plugins = fuzz::plugin_uses();
    InputBytes input(data, size);
    const fuzz::PluginUse& plugin = plugins[input.below(plugins.size())];
    const lxs::ParameterSet set = parameters_of(plugin, input);
    try {
        plugin.make_and_use(set);
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
