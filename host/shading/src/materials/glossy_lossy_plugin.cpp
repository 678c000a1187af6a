// Material "glossy_lossy": LuxRender's first glossy material, which loses light at grazing angles.
#include "bsdfs/fresnel_blend_bsdf.h"
#include "coated_diffuse.h"
#include "material_plugins.h"

namespace lxs::shading {

MaterialFactory glossy_lossy_plugin() {
    std::vector<ParameterDeclaration> own = coating_parameters();
    for (ParameterDeclaration& parameter : own)
        parameter.no_effect |= parameter.name == "multibounce";
    own.push_back(base_parameter());
    return {with_common_parameters(std::move(own)),
            &CoatedDiffuse<FresnelBlendBsdf, kDiffuse | kGlossy>::create};
}

}  // namespace lxs::shading
