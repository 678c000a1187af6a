// Materials "metal" (measured metals by name) and "metal2" (fresnel texture).
#include "common_parameters.h"
#include "conductor_material.h"
#include "material_plugins.h"
#include "metal_presets.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

std::shared_ptr<const Material> create_metal(const ParameterReader& reader,
                                             const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ConductorMaterial>(PreparedFresnel(read_metal_preset(reader, assets)),
                                               RoughSurface(reader, assets));
}

std::shared_ptr<const Material> create_metal2(const ParameterReader& reader,
                                              const AssetContext& assets, const Matrix&) {
    warn_of_common_parameters(reader);
    return std::make_shared<ConductorMaterial>(
        PreparedFresnel(read_fresnel_texture(reader, assets, "fresnel", 5)),
        RoughSurface(reader, assets));
}

/// Roughness along u and v, and the one name that old scenes have for both.
std::vector<ParameterDeclaration> old_and_new_roughness() {
    return declarations({{{"roughness", ParameterType::FloatTexture, "0.1",
                           "old name for both u and v roughness", 0}},
                         roughness_parameters("0.1")});
}

}  // namespace

MaterialFactory metal_plugin() {
    return {
        with_common_parameters(declarations({metal_preset_parameters(), old_and_new_roughness()})),
        &create_metal};
}

MaterialFactory metal2_plugin() {
    ParameterDeclaration fresnel{"fresnel", ParameterType::FresnelTexture, "5",
                                 "index of refraction or texture of optical constants"};
    fresnel.minimum = 1e-3;
    return {with_common_parameters(declarations({{fresnel}, old_and_new_roughness()})),
            &create_metal2};
}

}  // namespace lxs::shading
