// A texture as a material uses it: reading and limits.
#include "prepared_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "metal_presets.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

void warn_of_limit(const ParameterReader& reader, std::string_view name, float lowest,
                   float highest) {
    const std::string range = highest < kUnlimited ? fmt::format("{} to {}", lowest, highest)
                                                   : fmt::format("{} and above", lowest);
    std::string message = fmt::format("\"{}\" is limited to {}", reader.spelling(name), range);
    if (const auto texture = reader.texture_name(name))
        message += fmt::format(", and texture {} goes beyond", in_quotes(*texture));
    reader.diagnostics().warning(reader.where(name), message);
}

PreparedColor read_color(const ParameterReader& reader, const AssetContext& assets,
                         std::string_view name, const Rgb& fallback, ColourOf of) {
    constexpr float kHighest = 1;
    auto texture = read_color_texture(reader, assets, name, fallback);
    const std::optional<Rgb> value = texture->constant();
    if (value && limited(*value, 0, kHighest) != *value) warn_of_limit(reader, name, 0, kHighest);
    return {std::move(texture), 0, kHighest, of, reader.texture_name(name).value_or("")};
}

}  // namespace

PreparedColor read_reflectance(const ParameterReader& reader, const AssetContext& assets,
                               std::string_view name, const Rgb& fallback) {
    return read_color(reader, assets, name, fallback, ColourOf::Surface);
}

PreparedColor constant_reflectance(const Rgb& value) {
    return {std::make_shared<ConstantTexture<Rgb>>(value), 0, 1, ColourOf::Surface};
}

PreparedColor read_absorption(const ParameterReader& reader, const AssetContext& assets,
                              std::string_view name) {
    return read_color(reader, assets, name, Rgb(0.0f), ColourOf::Quantity);
}

PreparedFloat read_limited(const ParameterReader& reader, const AssetContext& assets,
                           std::string_view name, float fallback, float lowest, float highest) {
    auto texture = read_float_texture(reader, assets, name, fallback);
    const std::optional<float> value = texture->constant();
    if (value && reader.given(name) && std::clamp(*value, lowest, highest) != *value)
        warn_of_limit(reader, name, lowest, highest);
    return {std::move(texture), lowest, highest, ColourOf::Quantity,
            reader.texture_name(name).value_or("")};
}

PreparedFresnel::PreparedFresnel(std::shared_ptr<const FresnelTexture> texture) {
    if (const std::optional<FresnelValue> value = texture->constant()) {
        constant_ = possible(*value);
    } else {
        texture_ = std::move(texture);
    }
}

FresnelValue PreparedFresnel::interpolated(const FresnelValue& value,
                                           const Wavelengths& wavelengths) {
    FresnelValue result = value;
    for (int i = 0; i < 3; ++i) {
        const auto nm = static_cast<float>(wavelengths.nm[static_cast<std::size_t>(i)]);
        const int first = nm > kRgbWavelengths[1] ? 0 : 1;  // of the pair around nm
        const float a = kRgbWavelengths[static_cast<std::size_t>(first)];
        const float b = kRgbWavelengths[static_cast<std::size_t>(first) + 1];
        const float t = std::clamp((nm - a) / (b - a), 0.0f, 1.0f);
        result.eta[i] = value.eta[first] + t * (value.eta[first + 1] - value.eta[first]);
        result.k[i] = value.k[first] + t * (value.k[first + 1] - value.k[first]);
    }
    return result;
}

}  // namespace lxs::shading
