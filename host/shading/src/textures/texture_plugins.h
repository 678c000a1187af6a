// The texture plugins, one factory each; defined in the file named after the plugin.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

FloatTextureFactory constant_float_plugin();
ColorTextureFactory constant_color_plugin();
FresnelTextureFactory constant_fresnel_plugin();
FloatTextureFactory scale_float_plugin();
ColorTextureFactory scale_color_plugin();
FloatTextureFactory mix_float_plugin();
ColorTextureFactory mix_color_plugin();
FloatTextureFactory checkerboard_plugin();
FresnelTextureFactory fresnelcolor_plugin();
FresnelTextureFactory fresnelname_plugin();
FresnelTextureFactory mix_fresnel_plugin();
FresnelTextureFactory cauchy_plugin();
FresnelTextureFactory sellmeier_plugin();
FresnelTextureFactory abbe_plugin();
FresnelTextureFactory sopra_plugin();
FresnelTextureFactory luxpop_plugin();
/// Reads its image as the colour texture "imagemap" does.
FloatTextureFactory normalmap_plugin(const ColorTextureFactory& imagemap);
/// Adds "imagemap" for floats and colours, which share one image cache.
void register_imagemaps(Registry& registry);

}  // namespace lxs::shading
