// A texture as a material uses it: reading and limits.
#include "prepared_texture.h"

#include <fmt/format.h>

#include <limits>

#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

void warn_outside(const ParameterReader& reader, std::string_view name, const Rgb& value,
                  float highest) {
    const Rgb inside = limited(value, 0, highest);
    if (inside == value) return;
    reader.diagnostics().warning(
        reader.where(name),
        fmt::format("\"{}\" is limited to {}", name, highest == 1 ? "0 to 1" : "0 and above"));
}

PreparedColor read_color(const ParameterReader& reader, const AssetContext& assets,
                         std::string_view name, const Rgb& fallback, float highest) {
    auto texture = read_color_texture(reader, assets, name, fallback);
    if (const std::optional<Rgb> value = texture->constant())
        warn_outside(reader, name, *value, highest);
    return {std::move(texture), 0, highest};
}

}  // namespace

PreparedColor read_reflectance(const ParameterReader& reader, const AssetContext& assets,
                               std::string_view name, const Rgb& fallback) {
    return read_color(reader, assets, name, fallback, 1);
}

PreparedColor read_positive_color(const ParameterReader& reader, const AssetContext& assets,
                                  std::string_view name, const Rgb& fallback) {
    return read_color(reader, assets, name, fallback, kLargest);
}

PreparedFloat read_limited(const ParameterReader& reader, const AssetContext& assets,
                           std::string_view name, float fallback, float lowest, float highest) {
    return {read_float_texture(reader, assets, name, fallback), lowest, highest};
}

PreparedFresnel::PreparedFresnel(std::shared_ptr<const FresnelTexture> texture) {
    if (const std::optional<FresnelValue> value = texture->constant()) {
        constant_ = *value;
    } else {
        texture_ = std::move(texture);
    }
}

}  // namespace lxs::shading
