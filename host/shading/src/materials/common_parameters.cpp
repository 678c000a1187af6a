// Parameters that every material has.
#include "common_parameters.h"

#include "ignored_parameter.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

std::vector<ParameterDeclaration> compositing_parameters() {
    using enum ParameterType;
    return {ignored("compo_visible_material", Bool, "true", "seen by camera rays"),
            ignored("compo_visible_emission", Bool, "true", "emission seen by camera rays"),
            ignored("compo_visible_indirect_material", Bool, "true", "seen by other rays"),
            ignored("compo_visible_indirect_emission", Bool, "true", "emission seen by other rays"),
            ignored("compo_override_alpha", Bool, "false", "replace the alpha channel"),
            ignored("compo_override_alpha_value", Float, "0", "alpha that replaces it"),
            ignored("compo_use_key", Bool, "false", "chroma key"),
            ignored("compo_key_color", Color, "0 0 1", "colour of the chroma key"),
            ignored("bumpmapsampledistance", Float, "0.001", "step of the bump map's slope")};
}

}  // namespace

std::vector<ParameterDeclaration> joined(std::vector<ParameterDeclaration> a,
                                         const std::vector<ParameterDeclaration>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::vector<ParameterDeclaration> with_common_parameters(std::vector<ParameterDeclaration> own) {
    own.push_back({"bumpmap", ParameterType::FloatTexture, "",
                   "height above the surface, scene units (not rendered yet)"});
    return joined(std::move(own), compositing_parameters());
}

void warn_of_common_parameters(const ParameterReader& reader, const AssetContext& assets) {
    if (!reader.given("bumpmap")) return;
    // A constant height has no slope, so nothing is missing.
    if (read_float_texture(reader, assets, "bumpmap", 0)->constant()) return;
    reader.diagnostics().warning(reader.where("bumpmap"), "bump maps are not rendered yet");
}

std::vector<ParameterDeclaration> film_parameters() {
    return {{"film", ParameterType::FloatTexture, "0",
             "thickness of a thin film, nanometres (not rendered yet)"},
            {"filmindex", ParameterType::FloatTexture, "1.5",
             "index of the thin film (not rendered yet)"}};
}

void warn_of_film(const ParameterReader& reader, const AssetContext& assets) {
    if (!reader.given("film")) return;
    if (read_float_texture(reader, assets, "film", 0)->constant() == 0.0f) return;
    reader.diagnostics().warning(reader.where("film"), "thin films are not rendered yet");
}

std::vector<ParameterDeclaration> roughness_parameters(std::string_view default_text) {
    return {{"uroughness", ParameterType::FloatTexture, default_text,
             "roughness along u, 0.006 to 1", 0},
            {"vroughness", ParameterType::FloatTexture, default_text,
             "roughness along v, 0.006 to 1", 0}};
}

}  // namespace lxs::shading
