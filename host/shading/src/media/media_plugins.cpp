// Media "clear" (absorbing) and "homogeneous" (its absorption only).
#include "media_plugins.h"

#include <fmt/format.h>

#include "lxs/spectrum/colour_matching.h"
#include "materials/metal_presets.h"
#include "materials/prepared_texture.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

/// The value of a texture that must be the same everywhere in a medium.
template <class T>
T value_everywhere(const std::shared_ptr<const Texture<T>>& texture, const ParameterReader& reader,
                   std::string_view name) {
    if (const std::optional<T> value = texture->constant()) return *value;
    reader.diagnostics().warning(reader.where(name),
                                 fmt::format("\"{}\" varies in space, which is not rendered yet; "
                                             "its value at the origin is used",
                                             name));
    return texture->evaluate(TexturePoint{});
}

IndexCurve read_index(const ParameterReader& reader, const AssetContext& assets) {
    const auto texture = read_fresnel_texture(reader, assets, "fresnel", 1);
    const Rgb eta = value_everywhere(texture, reader, "fresnel").eta;
    const IndexCurve index =
        eta == Rgb(eta.x) ? IndexCurve{eta.x}
                          : index_curve_through({kRgbWavelengths[0], kRgbWavelengths[1],
                                                 kRgbWavelengths[2]},
                                                eta);
    for (const double nm : {kFirstVisibleNm, kMiddleNm, kLastVisibleNm}) {
        if (!(index.at(nm) > 0))
            reader.fail("fresnel", "the index of refraction must be above 0 for visible light");
    }
    return index;
}

std::shared_ptr<const Medium> make_medium(const ParameterReader& reader, const AssetContext& assets,
                                          std::string_view absorption) {
    const auto texture = read_color_texture(reader, assets, absorption, Rgb(0.0f));
    const Rgb value = value_everywhere(texture, reader, absorption);
    const Rgb inside = limited(value, 0, std::numeric_limits<float>::max());
    if (inside != value) {
        reader.diagnostics().warning(reader.where(absorption),
                                     fmt::format("\"{}\" is limited to 0 and above", absorption));
    }
    return std::make_shared<Medium>(inside, read_index(reader, assets));
}

ParameterDeclaration fresnel_parameter() {
    ParameterDeclaration fresnel{"fresnel", ParameterType::FresnelTexture, "1",
                                 "index of refraction, for \"glass2\""};
    fresnel.minimum = 1e-3;
    return fresnel;
}

}  // namespace

MediumFactory clear_plugin() {
    return {
        {fresnel_parameter(),
         {"absorption", ParameterType::ColorTexture, "0 0 0", "absorption per unit of distance"}},
        [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            return make_medium(reader, assets, "absorption");
        }};
}

MediumFactory homogeneous_plugin() {
    using enum ParameterType;
    return {
        {fresnel_parameter(),
         {"sigma_a", ColorTexture, "0 0 0", "absorption per unit of distance"},
         {"sigma_s", ColorTexture, "0 0 0", "scattering per unit of distance (not rendered yet)"},
         {"g", ColorTexture, "0 0 0", "asymmetry of scattering (not rendered yet)"}},
        [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            const auto scattering = read_color_texture(reader, assets, "sigma_s", Rgb(0.0f));
            if (scattering->constant() != Rgb(0.0f)) {
                reader.diagnostics().warning(
                    reader.where("sigma_s"),
                    "scattering in media is not rendered yet; only absorption is");
            }
            return make_medium(reader, assets, "sigma_a");
        }};
}

}  // namespace lxs::shading
