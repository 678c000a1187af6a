// Statements of the world block: attributes, named things, lights, shapes.
#include <fmt/format.h>

#include <filesystem>

#include "area_emission.h"
#include "scene_reader.h"
#include "textures_by_name.h"

namespace lxs {
namespace {

/// Stays the same wherever the scene lies.
std::string name_by_place(const std::string& plugin, const SourceLocation& where) {
    const std::string file = std::filesystem::path(where.file->name).filename().string();
    return fmt::format("{} ({}:{})", plugin, file, where.line);
}

/// The shape's own name, as exporters give it.
std::string shape_name(const ParameterSet& set, const SourceLocation& where) {
    for (const ParameterValue& value : set.values) {
        const auto* texts = std::get_if<std::vector<std::string>>(&value.values);
        if (value.name == "name" && texts && texts->size() == 1 && !texts->front().empty())
            return texts->front();
    }
    return name_by_place(set.plugin, where);
}

/// Takes the parameter "string type" out of a set: MakeNamedMaterial's plugin name. As in LuxRender
/// it counts only if it is one string, and then the last one does.
Name take_type(ParameterSet& set, std::string_view default_type, Diagnostics& diagnostics) {
    Name type{std::string(default_type), set.where};
    for (const ParameterValue& value : set.values) {
        if (value.name != "type") continue;
        const auto* strings = std::get_if<std::vector<std::string>>(&value.values);
        if (!strings || strings->size() != 1 || value.type != "string") {
            if (value.type == "string") type = {std::string(default_type), set.where};
            diagnostics.fallback(value.where,
                                 "the material's type is written \"string type\" [\"name\"]",
                                 type.text + " is used");
            continue;
        }
        type = {strings->front(), value.value_where.empty() ? value.where : value.value_where[0]};
    }
    std::erase_if(set.values, [](const ParameterValue& value) { return value.name == "type"; });
    return type;
}

}  // namespace

void SceneReader::attribute_begin(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.begin(ScopeKind::Attribute, statement.where);
}

void SceneReader::attribute_end(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.end(ScopeKind::Attribute, statement.where, diagnostics_);
}

void SceneReader::reverse_orientation(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.graphics.reverse_orientation = !scopes_.graphics.reverse_orientation;
}

void SceneReader::texture(Statement& statement) {
    const Name name = take_name(statement, 0);
    const Name type = take_name(statement, 1);
    const ParameterSet set = take_parameters(statement, 3, take_name(statement, 2));
    bool is_new = false;
    if (type.text == "float") {
        is_new = assets_.define(name.text, factory_.float_texture(set, scopes_.transform));
    } else if (type.text == "color") {
        is_new = assets_.define(name.text, factory_.color_texture(set, scopes_.transform));
    } else if (type.text == "fresnel") {
        is_new = assets_.define(name.text, factory_.fresnel_texture(set, scopes_.transform));
    } else {
        throw IgnoredStatement(type.where, unknown_name_message("texture type", type.text,
                                                                {"float", "color", "fresnel"}));
    }
    warn_redefined(is_new, "texture", name);
}

IndexedMaterial SceneReader::add_material(const ParameterSet& set, std::string name) {
    IndexedMaterial added;
    added.material = factory_.material(set, scopes_.transform);
    added.index = static_cast<std::uint32_t>(contents_.material_names.size());
    contents_.material_names.push_back(std::move(name));
    return added;
}

void SceneReader::material(Statement& statement) {
    const ParameterSet set = take_plugin(statement);
    const SourceLocation& where = statement.where;
    const IndexedMaterial made = add_material(set, name_by_place(set.plugin, where));
    scopes_.graphics.material = made.material;
    scopes_.graphics.material_index = made.index;
}

void SceneReader::make_named_material(Statement& statement) {
    const Name name = take_name(statement, 0);
    ParameterSet set = take_parameters(statement, 1, name);
    const Name type = take_type(set, "matte", diagnostics_);
    set.plugin = type.text;
    set.where = type.where;
    warn_redefined(assets_.define(name.text, add_material(set, name.text)), "material", name);
}

void SceneReader::named_material(Statement& statement) {
    const IndexedMaterial& named = assets_.indexed_material(take_only_name(statement));
    scopes_.graphics.material = named.material;
    scopes_.graphics.material_index = named.index;
}

const IndexedMaterial& SceneReader::default_material() {
    if (!default_material_.material) {
        ParameterSet matte;
        matte.plugin = "matte";
        default_material_ = add_material(matte, "default");
        contents_.implied_material = default_material_.index;
    }
    return default_material_;
}

void SceneReader::make_named_volume(Statement& statement) {
    const Name name = take_name(statement, 0);
    const ParameterSet set = take_parameters(statement, 2, take_name(statement, 1));
    std::optional<SceneMedium> made = factory_.medium(set, scopes_.transform);
    const bool is_new = assets_.define(name.text, made ? made->medium : nullptr);
    if (made) {
        made->name = name.text;
        if (made->medium->emits()) made->group = group_index(scopes_.graphics.light_group);
        made->where = set.where;
        contents_.media.push_back(std::move(*made));
    }
    warn_redefined(is_new, "volume", name);
}

void SceneReader::interior(Statement& statement) {
    const Name name = take_only_name(statement);
    scopes_.graphics.interior = name.text.empty() ? nullptr : assets_.medium(name);
}

void SceneReader::exterior(Statement& statement) {
    const Name name = take_only_name(statement);
    scopes_.graphics.exterior = name.text.empty() ? nullptr : assets_.medium(name);
}

void SceneReader::volume_region(Statement& statement) {
    factory_.volume_region(take_plugin(statement));
}

void SceneReader::light_group(Statement& statement) {
    const Name name = take_name(statement, 0);
    const ParameterSet set = take_parameters(statement, 1, name);
    if (!set.values.empty()) {
        diagnostics_.warning(set.values.front().where,
                             "parameters of LightGroup have no effect here");
    }
    scopes_.graphics.light_group = name.text.empty() ? "default" : name.text;
}

std::uint32_t SceneReader::group_index(const std::string& name) {
    const auto next = static_cast<std::uint32_t>(contents_.light_groups.size());
    const auto [entry, is_new] = group_indices_.try_emplace(name, next);
    if (is_new) contents_.light_groups.push_back(name);
    return entry->second;
}

void SceneReader::light_source(Statement& statement) {
    LightDescription light;
    light.parameters = take_plugin(statement);
    evaluate_light_colours(light.parameters, assets_, diagnostics_);
    light.to_world = still_transform("light", statement.where);
    light.group = group_index(scopes_.graphics.light_group);
    light.medium = scopes_.graphics.exterior;
    if (objects_.open()) {
        objects_.add(std::move(light));
    } else {
        contents_.lights.push_back(std::move(light));
    }
}

void SceneReader::area_light_source(Statement& statement) {
    const ParameterSet set = take_plugin(statement);
    scopes_.graphics.emission =
        std::make_shared<AreaEmission>(make_area_emission(set, assets_, diagnostics_));
}

void SceneReader::shape(Statement& statement) {
    ParameterSet set = take_plugin(statement);
    name_displacement_as_texture(set);
    const GraphicsState& graphics = scopes_.graphics;
    std::optional<Geometry> geometry =
        factory_.shape(set, still_transform("shape", statement.where));
    if (!geometry) return;
    Primitive primitive;
    primitive.geometry = std::move(*geometry);
    primitive.name = shape_name(set, statement.where);
    primitive.material = graphics.material;
    primitive.material_index = graphics.material_index;
    primitive.to_world = scopes_.transform;
    primitive.interior = graphics.interior;
    primitive.exterior = graphics.exterior;
    if (graphics.emission) {
        primitive.emission = *graphics.emission;
        primitive.emission->group = group_index(graphics.light_group);
    }
    const bool mirrors = scopes_.transform.determinant() < 0;
    primitive.reverse_orientation = graphics.reverse_orientation != mirrors;
    primitive.where = statement.where;
    if (objects_.open()) {
        objects_.add(std::move(primitive));
        return;
    }
    if (!primitive.material) {
        const IndexedMaterial& fallback = default_material();
        primitive.material = fallback.material;
        primitive.material_index = fallback.index;
    }
    contents_.primitives.push_back(std::move(primitive));
}

void SceneReader::portal_shape(Statement& statement) {
    take_plugin(statement);
    diagnostics_.warning(statement.where, "portals are not used: they only guide sampling");
}

void SceneReader::portal_instance(Statement& statement) {
    take_only_name(statement);
    diagnostics_.warning(statement.where, "portals are not used: they only guide sampling");
}

void SceneReader::warn_redefined(bool is_new, const char* noun, const Name& name) {
    if (is_new) return;
    diagnostics_.warning(name.where, fmt::format("{} {} is defined again: uses below take this one",
                                                 noun, in_quotes(name.text)));
}

}  // namespace lxs
