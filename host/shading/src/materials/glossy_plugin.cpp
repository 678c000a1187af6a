// Material "glossy" (old names "substrate" and "plastic"): diffuse base under a rough coating.
#include "bsdfs/glossy_bsdf.h"
#include "coated_diffuse.h"
#include "material_plugins.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {

MaterialFactory glossy_plugin() {
    return {with_common_parameters(declarations({{base_parameter()}, coating_parameters()})),
            &CoatedDiffuse<GlossyBsdf, kGlossy>::create};
}

}  // namespace lxs::shading
