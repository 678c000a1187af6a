// Dispatch of statements, the world block, included files.
#include "scene_reader.h"

#include "included_files.h"
#include "lxs/language/parse_file.h"
#include "no_messages.h"
#include "waiting_statements.h"

namespace lxs {
namespace {

constexpr std::size_t kMostErrors = 5000;  // a file with more is no scene

}  // namespace

const std::map<std::string, SceneReader::Rule>& SceneReader::rules() {
    using Self = SceneReader;
    static const std::map<std::string, Rule> table = {
        {"Accelerator", {&Self::option, Block::BeforeWorld}},
        {"AreaLightSource", {&Self::area_light_source, Block::World}},
        {"AttributeBegin", {&Self::attribute_begin, Block::World}},
        {"AttributeEnd", {&Self::attribute_end, Block::World}},
        {"Camera", {&Self::option, Block::BeforeWorld}},
        {"ConcatTransform", {&Self::concat_transform, Block::Anywhere, true}},
        {"CoordSysTransform", {&Self::coord_sys_transform, Block::Anywhere, true}},
        {"CoordinateSystem", {&Self::coordinate_system}},
        {"Exterior", {&Self::exterior}},
        {"Film", {&Self::option, Block::BeforeWorld}},
        {"Identity", {&Self::identity, Block::Anywhere, true}},
        {"Include", {&Self::include}},
        {"Interior", {&Self::interior}},
        {"LightGroup", {&Self::light_group, Block::World}},
        {"LightSource", {&Self::light_source, Block::World}},
        {"LookAt", {&Self::look_at_statement, Block::Anywhere, true}},
        {"MakeNamedMaterial", {&Self::make_named_material}},
        {"MakeNamedVolume", {&Self::make_named_volume}},
        {"Material", {&Self::material, Block::World}},
        {"MotionBegin", {&Self::motion_begin}},
        {"MotionEnd", {&Self::motion_end, Block::Anywhere, true}},
        {"MotionInstance", {&Self::motion_instance, Block::World}},
        {"NamedMaterial", {&Self::named_material, Block::World}},
        {"ObjectBegin", {&Self::object_begin, Block::World}},
        {"ObjectEnd", {&Self::object_end, Block::World}},
        {"ObjectInstance", {&Self::object_instance, Block::World}},
        {"PixelFilter", {&Self::option, Block::BeforeWorld}},
        {"PortalInstance", {&Self::portal_instance, Block::World}},
        {"PortalShape", {&Self::portal_shape, Block::World}},
        {"Renderer", {&Self::option, Block::BeforeWorld}},
        {"ReverseOrientation", {&Self::reverse_orientation, Block::World}},
        {"Rotate", {&Self::rotate, Block::Anywhere, true}},
        {"Sampler", {&Self::option, Block::BeforeWorld}},
        {"Scale", {&Self::scale, Block::Anywhere, true}},
        {"SearchPath", {&Self::search_path}},
        {"Shape", {&Self::shape, Block::World}},
        {"SurfaceIntegrator", {&Self::option, Block::BeforeWorld}},
        {"Texture", {&Self::texture}},
        {"Transform", {&Self::transform, Block::Anywhere, true}},
        {"TransformBegin", {&Self::transform_begin}},
        {"TransformEnd", {&Self::transform_end}},
        {"Translate", {&Self::translate, Block::Anywhere, true}},
        {"Volume", {&Self::volume_region, Block::World}},
        {"VolumeIntegrator", {&Self::option, Block::BeforeWorld}},
        {"VolumeRegion", {&Self::volume_region, Block::World}},
        {"WorldBegin", {&Self::world_begin, Block::BeforeWorld}},
        {"WorldEnd", {&Self::world_end, Block::World}},
    };
    return table;
}

SceneReader::SceneReader(const std::string& directory, const Registry& registry,
                         Diagnostics& diagnostics)
    : diagnostics_(diagnostics),
      finder_(directory),
      ahead_(registry, finder_),
      assets_(finder_, files_.assets, ahead_, unknown_, diagnostics),
      factory_(registry, assets_, diagnostics_),
      objects_(unknown_, diagnostics_) {
    contents_.directory = directory;
    coordinate_systems_["world"] = Matrix();
}

void SceneReader::read(const std::shared_ptr<const SourceFile>& file) {
    opened(file);
    WaitingStatements waiting(
        [this](std::vector<Statement> them) { execute_all(std::move(them)); });
    try {
        parse_file(file, [&](Statement& statement) { waiting.add(std::move(statement)); });
    } catch (const InputError&) {
        waiting.release();  // what stands before bad syntax comes first
        throw;
    }
    waiting.release();
}

void SceneReader::execute_all(std::vector<Statement> statements) {
    if (!ended_) ahead_.read(statements);
    for (Statement& statement : statements)
        execute(statement);
    ahead_.forget();
}

SceneContents SceneReader::finish() {
    if (in_world_) {
        diagnostics_.error(InputError(last_statement_, "the scene ends without WorldEnd"));
        close_world(last_statement_);
    } else if (!ended_) {
        diagnostics_.error(InputError(last_statement_, "the scene ends without WorldBegin"));
    }
    if (contents_.light_groups.empty()) contents_.light_groups.emplace_back("default");
    return std::move(contents_);
}

void SceneReader::execute(Statement& statement) {
    guard([&] { interpret(statement); });
}

void SceneReader::guard(const std::function<void()>& action) {
    try {
        action();
    } catch (const EndOfReading&) {
        throw;
    } catch (const IgnoredStatement& ignored) {
        diagnostics_.fallback(ignored.where(), ignored.message(), "it is ignored");
    } catch (const InputError& error) {
        diagnostics_.error(error);
        if (++errors_ < kMostErrors) return;
        throw EndOfReading(error.where(), "more than " + std::to_string(kMostErrors - 1) +
                                              " errors: reading ends here");
    }
}

void SceneReader::interpret(Statement& statement) {
    last_statement_ = statement.where;
    if (ended_) {
        diagnostics_.warning(statement.where, "what follows WorldEnd is not read");
        return;
    }
    const auto rule = rules().find(statement.name);
    if (rule == rules().end()) {
        const std::string message = "unknown statement " + in_quotes(statement.name);
        const std::string nearest = nearest_name(statement.name, names_of(rules()));
        throw InputError(statement.where,
                         nearest.empty() ? message : message + "; did you mean " + nearest + "?");
    }
    check_place(statement, rule->second);
    (this->*rule->second.method)(statement);
}

void SceneReader::check_place(const Statement& statement, const Rule& rule) const {
    if (motion_ && !rule.in_motion) {
        throw IgnoredStatement(
            statement.where,
            statement.name + " between MotionBegin and MotionEnd: only transforms");
    }
    if (rule.block == Block::World && !in_world_) {
        throw IgnoredStatement(statement.where, statement.name + " stands after WorldBegin only");
    }
    if (rule.block == Block::BeforeWorld && in_world_) {
        throw IgnoredStatement(statement.where, statement.name + " stands before WorldBegin only");
    }
}

void SceneReader::world_begin(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.transform = Matrix();
    scopes_.motion.clear();
    in_world_ = true;
}

void SceneReader::world_end(Statement& statement) {
    expect_no_arguments(statement);
    close_world(statement.where);
}

void SceneReader::close_world(const SourceLocation& where) {
    if (const SourceLocation* object = objects_.open()) {
        diagnostics_.error(InputError(*object, "ObjectBegin is not closed by ObjectEnd"));
        objects_.end(where);
    }
    contents_.end = where;
    contents_.camera_medium = scopes_.graphics.exterior;
    scopes_.close_all(diagnostics_);
    Inheritance fallback;
    if (objects_.lacks_material()) {
        const IndexedMaterial& material = default_material();
        fallback.material = material.material;
        fallback.material_index = material.index;
    }
    objects_.finish(fallback, contents_);
    in_world_ = false;
    ended_ = true;
}

void SceneReader::include(Statement& statement) {
    const Name file = take_only_name(statement);
    const auto source = open(file);
    // Messages show lines of scenes, but a scene may name any file of whoever renders it.
    const auto word = first_word(*source->text);
    if (word && !rules().contains(std::string(*word))) {
        throw InputError(file.where, in_quotes(source->name) +
                                         " is no scene file: it does not begin with a statement");
    }
    read(source);
}

std::shared_ptr<const SourceFile> SceneReader::open(const Name& file) {
    return open_include(file, finder_, included_, diagnostics_);
}

std::string SceneReader::find_quietly(const Name& file) {
    NoMessages silent;
    try {
        return finder_.find(file.text, file.where, silent);
    } catch (const InputError&) {
        return {};
    }
}

void SceneReader::search_path(Statement& statement) {
    take_only_name(statement);
    diagnostics_.warning(statement.where, "SearchPath has no effect");
}

}  // namespace lxs
