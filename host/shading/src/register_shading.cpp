// The textures, materials and media of the host, by the names scene files use.
#include "lxs/scene/registry.h"
#include "materials/bumped_material.h"
#include "materials/material_plugins.h"
#include "media/media_plugins.h"
#include "textures/texture_plugins.h"

namespace lxs {
namespace {

void register_textures(Registry& registry) {
    registry.float_textures["constant"] = shading::constant_float_plugin();
    registry.float_textures["scale"] = shading::scale_float_plugin();
    registry.float_textures["checkerboard"] = shading::checkerboard_plugin();
    registry.color_textures["constant"] = shading::constant_color_plugin();
    registry.color_textures["scale"] = shading::scale_color_plugin();
    registry.fresnel_textures["constant"] = shading::constant_fresnel_plugin();
    registry.fresnel_textures["fresnelcolor"] = shading::fresnelcolor_plugin();
    registry.fresnel_textures["fresnelname"] = shading::fresnelname_plugin();
    registry.fresnel_textures["preset"] = shading::fresnelname_plugin();
    registry.fresnel_textures["sellmeier"] = shading::sellmeier_plugin();
    registry.fresnel_textures["abbe"] = shading::abbe_plugin();
    registry.fresnel_textures["sopra"] = shading::sopra_plugin();
    registry.fresnel_textures["luxpop"] = shading::luxpop_plugin();
    registry.fresnel_textures["cauchy"] = shading::cauchy_plugin();
    registry.color_textures["colordepth"] = shading::colordepth_plugin();
    registry.color_textures["lampspectrum"] = shading::lampspectrum_plugin();
    shading::register_imagemaps(registry);
    registry.float_textures["normalmap"] =
        shading::normalmap_plugin(registry.color_textures.at("imagemap"));
    shading::register_noise_textures(registry);
    shading::register_pattern_textures(registry);
    shading::register_bricks(registry);
    shading::register_mixes(registry);
    shading::register_nodes(registry);
    shading::register_sum_textures(registry);
    shading::register_spectral_textures(registry);
    shading::register_sampled_spectra(registry);
    shading::register_hitpoint_textures(registry);
    shading::register_density_textures(registry);
    shading::register_grids(registry);
    shading::register_blender_noises(registry);
    shading::register_blender_waves(registry);
    registry.float_textures["blender_musgrave"] = shading::blender_musgrave_plugin();
}

void register_materials(Registry& registry) {
    registry.materials["carpaint"] = shading::carpaint_plugin();
    registry.materials["cloth"] = shading::cloth_plugin();
    registry.materials["matte"] = shading::matte_plugin();
    registry.materials["mattetranslucent"] = shading::mattetranslucent_plugin();
    registry.materials["mirror"] = shading::mirror_plugin();
    registry.materials["glass"] = shading::glass_plugin();
    registry.materials["glass2"] = shading::glass2_plugin();
    registry.materials["metal"] = shading::metal_plugin();
    registry.materials["metal2"] = shading::metal2_plugin();
    registry.materials["roughglass"] = shading::roughglass_plugin();
    registry.materials["shinymetal"] = shading::shinymetal_plugin();
    registry.materials["glossy"] = shading::glossy_plugin();
    registry.materials["glossytranslucent"] = shading::glossytranslucent_plugin();
    registry.materials["substrate"] = shading::glossy_lossy_plugin();
    registry.materials["plastic"] = shading::glossy_lossy_plugin();
    registry.materials["glossycoating"] = shading::glossycoating_plugin();
    registry.materials["glossy_lossy"] = shading::glossy_lossy_plugin();
    registry.materials["layered"] = shading::layered_plugin();
    registry.materials["mix"] = shading::mix_plugin();
    registry.materials["null"] = shading::null_plugin();
    registry.materials["coateddiffuse"] = shading::coateddiffuse_plugin();
    registry.materials["doubleside"] = shading::doubleside_plugin();
    registry.materials["scatter"] = shading::scatter_plugin();
    registry.materials["velvet"] = shading::velvet_plugin();
}

}  // namespace

void register_shading(Registry& registry) {
    register_textures(registry);
    register_materials(registry);
    for (auto& [name, factory] : registry.materials)
        factory = shading::with_bump_map(std::move(factory));
    registry.media["clear"] = shading::clear_plugin();
    registry.media["homogeneous"] = shading::homogeneous_plugin();
    registry.media["heterogeneous"] = shading::heterogeneous_plugin();
}

}  // namespace lxs
