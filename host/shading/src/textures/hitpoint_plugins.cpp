// Vertex colours: "hitpointcolor", "hitpointgrey" and "hitpointalpha".
#include "formula_texture.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

std::shared_ptr<const FloatTexture> create_grey(const ParameterReader& reader, const AssetContext&,
                                                const Matrix&) {
    const auto channel = static_cast<int>(reader.integer("channel", -1));
    return formula_texture<float>([channel](const TexturePoint& point) {
        const Rgb& c = point.color;
        return channel >= 0 ? c[channel] : (c.x + c.y + c.z) / 3;
    });
}

}  // namespace

void register_hitpoint_textures(Registry& registry) {
    registry.color_textures["hitpointcolor"] = {
        {}, [](const ParameterReader&, const AssetContext&, const Matrix&) {
            return formula_texture<Rgb>([](const TexturePoint& point) { return point.color; });
        }};
    registry.float_textures["hitpointgrey"] = {
        {{"channel", ParameterType::Integer, "-1", "0 to 2: red to blue; -1: their mean", -1, 2}},
        &create_grey};
    registry.float_textures["hitpointalpha"] = {
        {}, [](const ParameterReader&, const AssetContext&, const Matrix&) {
            return formula_texture<float>([](const TexturePoint& point) { return point.alpha; });
        }};
}

}  // namespace lxs::shading
