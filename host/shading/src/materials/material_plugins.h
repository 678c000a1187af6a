// The material plugins, one factory each; defined in the file named after the plugin.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

MaterialFactory carpaint_plugin();
MaterialFactory cloth_plugin();
MaterialFactory coateddiffuse_plugin();
MaterialFactory doubleside_plugin();
MaterialFactory matte_plugin();
MaterialFactory mattetranslucent_plugin();
MaterialFactory mirror_plugin();
MaterialFactory glass_plugin();
MaterialFactory glass2_plugin();
MaterialFactory metal_plugin();
MaterialFactory metal2_plugin();
MaterialFactory roughglass_plugin();
MaterialFactory scatter_plugin();
MaterialFactory shinymetal_plugin();
MaterialFactory glossy_plugin();
MaterialFactory glossytranslucent_plugin();
MaterialFactory glossycoating_plugin();
MaterialFactory glossy_lossy_plugin();
MaterialFactory layered_plugin();
MaterialFactory mix_plugin();
MaterialFactory null_plugin();
MaterialFactory velvet_plugin();

}  // namespace lxs::shading
