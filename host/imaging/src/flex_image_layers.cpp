// Layers of the film one by one, for who looks on while a render goes on.
#include <algorithm>

#include "flex_image.h"

namespace lxs {
namespace {

HeldLayer of_colors(std::span<const Rgb> colors) {
    HeldLayer layer{.channels = 3};
    layer.values.reserve(3 * colors.size());
    for (const Rgb& c : colors)
        layer.values.insert(layer.values.end(), {c.x, c.y, c.z});
    return layer;
}

}  // namespace

std::vector<std::string> FlexImage::held_layers() const {
    std::vector<std::string> names;
    if (has_error_layer()) names.emplace_back(kErrorLayer);
    if (bias_) names.emplace_back(kBiasLayer);
    for (const auto& [name, layer] : color_layers_)
        names.push_back(name);
    for (const auto& [name, values] : layers_)
        names.push_back(name);
    if (light_groups() > 1) names.insert(names.end(), group_names_.begin(), group_names_.end());
    return names;
}

HeldLayer FlexImage::held_layer(std::string_view name) const {
    if (name == kErrorLayer && has_error_layer()) {
        return of_colors(film_colors(
            [this](std::span<Rgb> values) { error_->standard_errors(accumulator_, values); }));
    }
    if (name == kBiasLayer && bias_) return of_colors(bias_colors());
    if (const auto color = color_layers_.find(name); color != color_layers_.end()) {
        return of_colors(
            film_colors([&](std::span<Rgb> values) { color->second.resolve_total(values); }));
    }
    if (const auto floats = layers_.find(name); floats != layers_.end())
        return {.channels = 1, .values = floats->second};
    const auto group = std::find(group_names_.begin(), group_names_.end(), name);
    if (light_groups() < 2 || group == group_names_.end()) return {};
    const auto number = static_cast<std::uint32_t>(group - group_names_.begin());
    return of_colors(
        film_colors([&](std::span<Rgb> values) { accumulator_.resolve_group(number, values); }));
}

}  // namespace lxs
