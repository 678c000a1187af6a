// Parameters that name a texture in ways of their own.
#include "textures_by_name.h"

#include "lxs/spectrum/rgb_spectra.h"

namespace lxs {
namespace {

/// The L whose light has the texture's colour.
Rgb light_at_origin(const ColorTexture& texture) {
    TexturePoint point;
    point.use = ColourUse::Light;
    const Rgb colour = texture.evaluate(point);
    return texture.spectrum() ? illuminant_of_colour(colour * kLuminanceOfFlatSpectrum) : colour;
}

/// The texture that a light's value names as its colour; empty if it names none.
std::string colour_texture(const ParameterValue& value) {
    if (value.name != "L" && value.name != "I") return {};
    const auto* names = std::get_if<std::vector<std::string>>(&value.values);
    return value.type == "texture" && names && names->size() == 1 ? names->front() : "";
}

void set_colour(ParameterValue& value, const ColorTexture& texture, Diagnostics& diagnostics) {
    if (!texture.constant()) {
        diagnostics.warning(value.where, "\"" + value.name +
                                             "\" varies, which only area lights can: its "
                                             "colour at the origin is used");
    }
    const Rgb colour = light_at_origin(texture);
    value.type = "color";
    value.values = std::vector<double>{colour.x, colour.y, colour.z};
    value.value_where.clear();
}

}  // namespace

void evaluate_light_colours(ParameterSet& light, const AssetContext& assets,
                            Diagnostics& diagnostics) {
    std::vector<ParameterValue> values;
    for (ParameterValue& value : light.values) {
        const std::string name = colour_texture(value);
        if (!name.empty()) {
            const auto texture = assets.color_texture(name, value.where);
            if (!texture) continue;
            set_colour(value, *texture, diagnostics);
        }
        values.push_back(std::move(value));
    }
    light.values = std::move(values);
}

void name_displacement_as_texture(ParameterSet& shape) {
    for (ParameterValue& value : shape.values) {
        if (value.name == "displacementmap" && value.type == "string") value.type = "texture";
    }
}

}  // namespace lxs
