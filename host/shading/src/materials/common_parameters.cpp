// Parameters that every material has.
#include "common_parameters.h"

#include <fmt/format.h>

#include <array>

#include "bumped_material.h"
#include "ignored_parameter.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

/// LuxRender's compositing flags, which leave surfaces out of some of the rays.
std::vector<ParameterDeclaration> compositing_parameters() {
    using enum ParameterType;
    return {{"compo_visible_material", Bool, "true", "seen by camera rays (always is here)"},
            {"compo_visible_emission", Bool, "true", "emission seen by camera rays (always is)"},
            {"compo_visible_indirect_material", Bool, "true", "seen by other rays (always is)"},
            {"compo_visible_indirect_emission", Bool, "true",
             "emission seen by other rays (always is)"},
            {"compo_override_alpha", Bool, "false", "replace the alpha channel (never is here)"},
            ignored("compo_override_alpha_value", Float, "0", "alpha that replaces it"),
            {"compo_use_key", Bool, "false", "chroma key (never is used here)"},
            ignored("compo_key_color", Color, "0 0 1", "colour of the chroma key")};
}

/// A flag that would change the image, and what is rendered instead.
struct CompositingFlag {
    std::string_view name;
    bool plain;  ///< the value that changes nothing
    std::string_view instead;
};

constexpr CompositingFlag kCompositingFlags[] = {
    {"compo_visible_material", true, "the surface is seen by all rays"},
    {"compo_visible_emission", true, "the emission is seen by all rays"},
    {"compo_visible_indirect_material", true, "the surface is seen by all rays"},
    {"compo_visible_indirect_emission", true, "the emission is seen by all rays"},
    {"compo_override_alpha", false, "there is no alpha channel"},
    {"compo_use_key", false, "the surface keeps its colour"}};

}  // namespace

std::vector<ParameterDeclaration> with_common_parameters(std::vector<ParameterDeclaration> own) {
    return declarations({std::move(own), bump_map_parameters(), compositing_parameters()});
}

void warn_of_common_parameters(const ParameterReader& reader) {
    for (const CompositingFlag& flag : kCompositingFlags) {
        if (reader.boolean(flag.name, flag.plain) == flag.plain) continue;
        reader.diagnostics().warning(reader.where(flag.name),
                                     fmt::format("compositing is not rendered: {}", flag.instead));
    }
}

std::shared_ptr<const Material> read_named_material(const ParameterReader& reader,
                                                    const AssetContext& assets,
                                                    std::string_view name) {
    if (!reader.given(name))
        reader.fail(name, fmt::format("{}: \"{}\" is missing", reader.plugin(), name));
    return assets.material(reader.string(name, ""), reader.where(name));
}

std::vector<ParameterDeclaration> roughness_parameters(std::string_view default_text) {
    ParameterDeclaration u{"uroughness", ParameterType::FloatTexture, default_text,
                           "roughness along u, 0.006 to 1", 0};
    ParameterDeclaration v{"vroughness", ParameterType::FloatTexture, default_text,
                           "roughness along v, 0.006 to 1", 0};
    u.older_name = v.older_name = "roughness";
    return {u, v};
}

std::vector<ParameterDeclaration> facet_parameters(std::string_view default_roughness) {
    static constexpr std::array<std::string_view, 2> kDistributions{"schlick", "ggx"};
    return declarations(
        {roughness_parameters(default_roughness),
         {choice("distribution", "schlick",
                 "microfacets: LuxRender's, or those of Trowbridge and Reitz (GGX) with Smith's "
                 "shadowing, as pbrt and Cycles have them",
                 kDistributions)}});
}

RoughSurface::Facets read_facets(const ParameterReader& reader) {
    return reader.string("distribution", "schlick") == "ggx" ? RoughSurface::Facets::Smith
                                                             : RoughSurface::Facets::Schlick;
}

}  // namespace lxs::shading
