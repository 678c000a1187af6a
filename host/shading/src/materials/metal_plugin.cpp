// Materials "metal" (measured metals by name) and "metal2" (fresnel texture).
#include "common_parameters.h"
#include "conductor_material.h"
#include "material_plugins.h"
#include "metal_presets.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr float kRoughness = 0.1f;

std::shared_ptr<const Material> create_metal(const ParameterReader& reader,
                                             const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ConductorMaterial>(
        PreparedFresnel(read_metal_preset(reader, assets)),
        RoughSurface(reader, assets, kRoughness, "", read_facets(reader)));
}

std::shared_ptr<const Material> create_metal2(const ParameterReader& reader,
                                              const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ConductorMaterial>(
        PreparedFresnel(read_fresnel_texture(reader, assets, "fresnel", 5)),
        RoughSurface(reader, assets, kRoughness, "", read_facets(reader)));
}

}  // namespace

MaterialFactory metal_plugin() {
    return {
        with_common_parameters(declarations({metal_preset_parameters(), facet_parameters("0.1")})),
        &create_metal};
}

MaterialFactory metal2_plugin() {
    ParameterDeclaration fresnel{"fresnel", ParameterType::FresnelTexture, "5",
                                 "index of refraction or texture of optical constants"};
    fresnel.minimum = 1e-3;
    return {with_common_parameters(declarations({{fresnel}, facet_parameters("0.1")})),
            &create_metal2};
}

}  // namespace lxs::shading
