// Texture "brick": bricks and mortar.
#include <algorithm>
#include <array>

#include "brick_bond.h"
#include "formula_texture.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

/// In the order of BrickBond.
constexpr std::array<std::string_view, 7> kBonds{"stacked",    "running",     "flemish", "english",
                                                 "chain link", "herringbone", "basket"};

ParameterDeclaration length(std::string_view name, std::string_view fallback, std::string_view doc,
                            double least = 1e-6) {
    return {name, ParameterType::Float, fallback, doc, least};
}

BrickLayout read_layout(const ParameterReader& reader) {
    const auto number = [&](std::string_view name, double fallback) {
        return static_cast<float>(reader.number(name, fallback));
    };
    const std::string bond = reader.string("brickbond", "running");
    BrickLayout layout;
    layout.bond =
        static_cast<BrickBond>(std::find(kBonds.begin(), kBonds.end(), bond) - kBonds.begin());
    layout.size = {number("brickwidth", 0.3), number("brickdepth", 0.15),
                   number("brickheight", 0.1)};
    layout.mortar = number("mortarsize", 0.01);
    layout.run = number("brickrun", 0.75);
    if (number("brickbevel", 0) != 0) {
        reader.diagnostics().warning(reader.where("brickbevel"),
                                     "brick: bevels are not rendered; edges are sharp");
    }
    return layout;
}

template <class T>
std::vector<ParameterDeclaration> brick_parameters() {
    using Kind = TextureKind<T>;
    return declarations(
        {{choice("brickbond", "running",
                 "how bricks are laid; herringbone and basket on floors (x by y), the others in "
                 "walls (x by z), stacked in both",
                 kBonds),
          length("brickwidth", "0.3", "length of a brick with its joint"),
          length("brickheight", "0.1", "height of a brick with its joint"),
          length("brickdepth", "0.15", "depth of a brick with its joint"),
          length("mortarsize", "0.01", "width of the joints", 0),
          {"brickrun", ParameterType::Float, "0.75", "shift from row to row in lengths of bricks"},
          {"brickbevel", ParameterType::Float, "0", "width of bevelled edges: not rendered"},
          {"bricktex", Kind::kParameter, Kind::kWhite, "value in bricks"},
          {"brickmodtex", Kind::kParameter, Kind::kWhite, "factor on bricktex"},
          {"mortartex", Kind::kParameter, Kind::kMortar, "value in the joints"}},
         space_mapping_parameters()});
}

template <class T>
typename TextureKind<T>::Factory brick_plugin() {
    using Kind = TextureKind<T>;
    return {brick_parameters<T>(),
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix& to_world) {
                const auto brick = Kind::read(reader, assets, "bricktex", 1);
                const auto factor = Kind::read(reader, assets, "brickmodtex", 1);
                const auto mortar = Kind::read(reader, assets, "mortartex", 0.2f);
                return formula_texture<T>(
                    [=, layout = read_layout(reader),
                     mapping = SpaceMapping(reader, to_world)](const TexturePoint& point) {
                        return in_brick(layout, mapping(point))
                                   ? brick->evaluate(point) * factor->evaluate(point)
                                   : mortar->evaluate(point);
                    },
                    brick->reads_image() || factor->reads_image() || mortar->reads_image());
            }};
}

}  // namespace

void register_bricks(Registry& registry) {
    registry.float_textures["brick"] = brick_plugin<float>();
    registry.color_textures["brick"] = brick_plugin<Rgb>();
}

}  // namespace lxs::shading
