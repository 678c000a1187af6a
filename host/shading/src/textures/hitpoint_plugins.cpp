// Vertex colours: "hitpointcolor", "hitpointgrey" and "hitpointalpha".
#include "ignored_parameter.h"
#include "lxs/scene/constant_texture.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

/// White or opaque, which is also what LuxRender has for meshes without vertex colours.
template <class T>
std::shared_ptr<const Texture<T>> without_colours(const ParameterReader& reader,
                                                  const AssetContext&, const Matrix&) {
    reader.diagnostics().warning(reader.where(), reader.plugin() +
                                                     ": vertex colours of meshes are not read; 1 "
                                                     "is used instead");
    return std::make_shared<ConstantTexture<T>>(T(1.0f));
}

}  // namespace

void register_hitpoint_textures(Registry& registry) {
    registry.color_textures["hitpointcolor"] = {{}, &without_colours<Rgb>};
    registry.float_textures["hitpointgrey"] = {
        {ignored("channel", ParameterType::Integer, "-1", "0 to 2: red to blue, else the mean")},
        &without_colours<float>};
    registry.float_textures["hitpointalpha"] = {{}, &without_colours<float>};
}

}  // namespace lxs::shading
