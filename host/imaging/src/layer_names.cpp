// Names of the layers that a user may ask for.
#include "lxs/imaging/layer_names.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

using Member = bool LayersWanted::*;

struct NamedLayer {
    std::string_view name;
    Member wanted;
};

constexpr std::array kLayers{NamedLayer{"direct", &LayersWanted::direct},
                             NamedLayer{"indirect", &LayersWanted::indirect},
                             NamedLayer{"caustics", &LayersWanted::caustics},
                             NamedLayer{"albedo", &LayersWanted::albedo},
                             NamedLayer{"normal", &LayersWanted::normal},
                             NamedLayer{"depth", &LayersWanted::depth},
                             NamedLayer{"objects", &LayersWanted::objects},
                             NamedLayer{"materials", &LayersWanted::materials},
                             NamedLayer{"bias", &LayersWanted::bias}};
constexpr std::string_view kAll = "all", kCryptomatte = "cryptomatte";

bool asks_for(const std::string& name, const NamedLayer& layer) {
    const bool mask =
        layer.wanted == &LayersWanted::objects || layer.wanted == &LayersWanted::materials;
    return name == layer.name || name == kAll || (mask && name == kCryptomatte);
}

constexpr auto kNames = [] {
    std::array<std::string_view, kLayers.size() + 2> names;
    for (std::size_t i = 0; i < kLayers.size(); ++i)
        names[i] = kLayers[i].name;
    names[kLayers.size()] = kCryptomatte;
    names.back() = kAll;
    return names;
}();

void ask_for(const std::string& name, LayersWanted& wanted) {
    bool known = false;
    for (const NamedLayer& layer : kLayers) {
        if (!asks_for(name, layer)) continue;
        wanted.*layer.wanted = true;
        known = true;
    }
    if (known) return;
    throw std::invalid_argument(unknown_name_message(
        "layer", name, std::vector<std::string>(kNames.begin(), kNames.end())));
}

}  // namespace

std::span<const std::string_view> layer_names() {
    return kNames;
}

LayersWanted layers_named(std::span<const std::string> names) {
    LayersWanted wanted;
    for (const std::string& name : names)
        ask_for(name, wanted);
    return wanted;
}

std::vector<std::string> split_layer_names(std::string_view text) {
    std::vector<std::string> names;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        if (end > 0) names.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return names;
}

}  // namespace lxs
