// What all textures of the blender_* family share: a value in [0, 1] at a place in space.
#pragma once

#include "blender_noise.h"
#include "formula_texture.h"
#include "space_mapping.h"
#include "texture_parameters.h"

namespace lxs::shading {

/// A plugin with parameters `own`, brightness and contrast, and a mapping. `read` makes the
/// pattern, a function of Vec3, from the parameters.
template <class Read>
FloatTextureFactory blender_plugin(std::vector<ParameterDeclaration> own, Read read) {
    return {declarations({std::move(own), levels_parameters(), space_mapping_parameters()}),
            [read](const ParameterReader& reader, const AssetContext&, const Matrix& to_world) {
                return formula_texture<float>(
                    [pattern = read(reader), levels = read_levels(reader),
                     mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
                        return levels(pattern(mapping(point)));
                    });
            }};
}

}  // namespace lxs::shading
