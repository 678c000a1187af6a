// The texture plugins, one factory each; defined in the file named after the plugin.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs::shading {

FloatTextureFactory constant_float_plugin();
ColorTextureFactory constant_color_plugin();
FresnelTextureFactory constant_fresnel_plugin();
FloatTextureFactory scale_float_plugin();
ColorTextureFactory scale_color_plugin();
FloatTextureFactory checkerboard_plugin();
ColorTextureFactory colordepth_plugin();
ColorTextureFactory lampspectrum_plugin();
FresnelTextureFactory fresnelcolor_plugin();
FresnelTextureFactory fresnelname_plugin();
FresnelTextureFactory cauchy_plugin();
FresnelTextureFactory sellmeier_plugin();
FresnelTextureFactory abbe_plugin();
FresnelTextureFactory sopra_plugin();
FresnelTextureFactory luxpop_plugin();
/// Reads its image as the colour texture "imagemap" does.
FloatTextureFactory normalmap_plugin(const ColorTextureFactory& imagemap);
/// Adds "imagemap" for floats and colours, which share one image cache.
void register_imagemaps(Registry& registry);
void register_mixes(Registry& registry);             ///< mix
void register_nodes(Registry& registry);             ///< nodes
void register_noise_textures(Registry& registry);    ///< fbm, wrinkled, windy, marble
void register_pattern_textures(Registry& registry);  ///< bilerp, uv, uvmask, dots, harlequin
void register_bricks(Registry& registry);
void register_sum_textures(Registry& registry);       ///< add, subtract, multimix, band
void register_spectral_textures(Registry& registry);  ///< blackbody, equalenergy, gaussian, ...
void register_sampled_spectra(Registry& registry);    ///< regular-, irregular-, tabulateddata
void register_hitpoint_textures(Registry& registry);  ///< hitpointcolor, -grey, -alpha
void register_density_textures(Registry& registry);   ///< exponential, noisecloud
void register_grids(Registry& registry);              ///< densitygrid

void register_blender_noises(Registry& registry);  ///< blender_clouds, -voronoi, ...
void register_blender_waves(Registry& registry);   ///< blender_marble, -wood, -magic, -blend
FloatTextureFactory blender_musgrave_plugin();

}  // namespace lxs::shading
