// Texture "nodes": a graph of Blender's shader nodes. Not LuxRender's.
#include <stdexcept>

#include "lxs/spectrum/reflectance_colour.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "node_program.h"
#include "texture_list.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

std::shared_ptr<const nodes::NodeProgram> read_program(const ParameterReader& reader,
                                                       const AssetContext& assets) {
    nodes::NodeProgram::Inputs textures;
    for (std::size_t i = 1; i <= kLongestTextureList && reader.given(list_name(i)); ++i)
        textures.push_back(read_color_texture(reader, assets, list_name(i), Rgb(0.0f)));
    try {
        return std::make_shared<nodes::NodeProgram>(reader.strings("program"), std::move(textures));
    } catch (const std::runtime_error& error) {
        reader.fail("program", std::string("nodes: ") + error.what());
    }
}

class FloatNodes final : public FloatTexture {
  public:
    explicit FloatNodes(std::shared_ptr<const nodes::NodeProgram> program)
        : program_(std::move(program)) {}
    float evaluate(const TexturePoint& point) const override { return program_->evaluate(point).x; }
    std::optional<float> constant() const override {
        return program_->constant() ? std::optional(evaluate({})) : std::nullopt;
    }
    bool reads_image() const override { return program_->reads_image(); }
    float cell_size() const override { return program_->cell_size(); }

  private:
    std::shared_ptr<const nodes::NodeProgram> program_;
};

class ColorNodes final : public ColorTexture {
  public:
    ColorNodes(std::shared_ptr<const nodes::NodeProgram> program, bool plain)
        : program_(std::move(program)), plain_(plain) {}
    Rgb evaluate(const TexturePoint& point) const override {
        const Rgb value = program_->evaluate(point);
        if (!plain_) return value;
        const bool shines = point.use == ColourUse::Light && !reads_image();
        return shines ? illuminant_of_colour(value) : reflectance_of_colour(value);
    }
    std::optional<Rgb> constant() const override {
        return program_->constant() ? std::optional(evaluate({})) : std::nullopt;
    }
    bool reads_image() const override { return program_->reads_image(); }
    float cell_size() const override { return program_->cell_size(); }

  private:
    std::shared_ptr<const nodes::NodeProgram> program_;
    bool plain_;
};

std::vector<ParameterDeclaration> parameters() {
    ParameterDeclaration program{"program", ParameterType::String, "",
                                 "instructions, the last of which is the value"};
    program.array = true;
    return declarations(
        {{program}, texture_list_parameters<Rgb>("what instruction \"texture\" reads")});
}

}  // namespace

void register_nodes(Registry& registry) {
    registry.float_textures["nodes"] = {
        parameters(), [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            return std::make_shared<FloatNodes>(read_program(reader, assets));
        }};
    std::vector<ParameterDeclaration> color = parameters();
    color.push_back({"plaincolors", ParameterType::Bool, "false",
                     "surfaces show the colours as they are, as with imagemap"});
    registry.color_textures["nodes"] = {
        color, [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
            return std::make_shared<ColorNodes>(read_program(reader, assets),
                                                reader.boolean("plaincolors", false));
        }};
}

}  // namespace lxs::shading
