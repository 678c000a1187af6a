// Dispatch of directives, blocks, included files, the graphics state.
#include "translator.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lxs/language/parse_file.h"
#include "lxs/language/read_text.h"

namespace lxs::pbrt {
namespace {

constexpr std::size_t kMostScopes = 100'000;

/// Whether a file begins with a parameter: a string of a type and a name. Messages show lines of
/// scenes, but a scene may name any file of whoever renders it.
bool begins_with_parameter(const std::string& path) {
    static const std::vector<std::string_view> kTypes{
        "blackbody", "bool",    "color",  "float",   "integer", "normal",
        "normal3",   "point",   "point2", "point3",  "rgb",     "spectrum",
        "string",    "texture", "vector", "vector2", "vector3", "xyz"};
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        if (line[first] != '"') return false;
        const std::string_view rest = std::string_view(line).substr(first + 1);
        const std::size_t blank = rest.find_first_of(" \t");
        return blank != std::string_view::npos &&
               std::find(kTypes.begin(), kTypes.end(), rest.substr(0, blank)) != kTypes.end();
    }
    return false;
}

bool is_curve(const Statement& statement) {
    if (statement.name != "Shape" || statement.arguments.empty()) return false;
    const auto* const type = std::get_if<Strings>(&statement.arguments[0].values);
    return type != nullptr && type->size() == 1 && type->front() == "curve";
}

std::vector<std::string> names_of(const auto& map) {
    std::vector<std::string> names;
    for (const auto& entry : map)
        names.push_back(entry.first);
    return names;
}

}  // namespace

const std::map<std::string, Translator::Rule>& Translator::rules() {
    using Self = Translator;
    static const std::map<std::string, Rule> table = {
        {"Accelerator", {&Self::nothing, Block::Options}},
        {"ActiveTransform", {&Self::active_transform}},
        {"All", {&Self::active_transform}},
        {"AreaLightSource", {&Self::area_light_source, Block::World}},
        {"Attribute", {&Self::attribute}},
        {"AttributeBegin", {&Self::attribute_begin}},
        {"AttributeEnd", {&Self::attribute_end}},
        {"Camera", {&Self::camera, Block::Options}},
        {"ColorSpace", {&Self::colour_space_directive}},
        {"ConcatTransform", {&Self::concat_transform}},
        {"CoordSysTransform", {&Self::coord_sys_transform}},
        {"CoordinateSystem", {&Self::coordinate_system}},
        {"EndTime", {&Self::active_transform}},
        {"Film", {&Self::keep_option, Block::Options}},
        {"Identity", {&Self::identity}},
        {"Import", {&Self::import, Block::World}},
        {"Include", {&Self::include}},
        {"Integrator", {&Self::keep_option, Block::Options}},
        {"LightSource", {&Self::light_source, Block::World}},
        {"LookAt", {&Self::look_at_directive}},
        {"MakeNamedMaterial", {&Self::make_named_material}},
        {"MakeNamedMedium", {&Self::make_named_medium}},
        {"Material", {&Self::material, Block::World}},
        {"MediumInterface", {&Self::medium_interface}},
        {"NamedMaterial", {&Self::named_material, Block::World}},
        {"ObjectBegin", {&Self::object_begin, Block::World}},
        {"ObjectEnd", {&Self::object_end, Block::World}},
        {"ObjectInstance", {&Self::object_instance, Block::World}},
        {"Option", {&Self::option}},
        {"PixelFilter", {&Self::keep_option, Block::Options}},
        {"ReverseOrientation", {&Self::reverse_orientation}},
        {"Rotate", {&Self::rotate}},
        {"Sampler", {&Self::keep_option, Block::Options}},
        {"Scale", {&Self::scale}},
        {"Shape", {&Self::shape, Block::World}},
        {"StartTime", {&Self::active_transform}},
        {"SurfaceIntegrator", {&Self::keep_option, Block::Options}},
        {"Texture", {&Self::texture}},
        {"Transform", {&Self::transform}},
        {"TransformBegin", {&Self::transform_begin}},
        {"TransformEnd", {&Self::transform_end}},
        {"TransformTimes", {&Self::transform_times, Block::Options}},
        {"Translate", {&Self::translate_directive}},
        {"VolumeIntegrator", {&Self::nothing, Block::Options}},
        {"WorldBegin", {&Self::world_begin, Block::Options}},
        {"WorldEnd", {&Self::world_end, Block::World}},
    };
    return table;
}

Translator::Translator(StatementExecutor& executor, Diagnostics& diagnostics)
    : executor_(executor), diagnostics_(diagnostics), spectra_(executor) {}

void Translator::read(const std::shared_ptr<const SourceFile>& file, std::vector<Argument> more) {
    if (last_.file == nullptr) last_ = {file, 1, 1};
    executor_.opened(file);
    // One waits: an Include behind it may go on with its parameters.
    std::optional<Statement> waiting;
    const auto release = [&] {
        if (!waiting) return;
        Statement statement = std::move(*waiting);
        waiting.reset();
        executor_.guard([&] { translate(statement); });
    };
    parse_file(file, [&](Statement& statement) {
        bool joined = false;
        if (statement.name == "Include" && waiting)
            executor_.guard([&] { joined = join(statement, *waiting); });
        if (joined) return;
        release();
        waiting = std::move(statement);
    });
    if (waiting) std::move(more.begin(), more.end(), std::back_inserter(waiting->arguments));
    release();
}

bool Translator::join(Statement& include, Statement& before) {
    // Only what begins with parameters: of other files the directive itself takes care.
    if (include.arguments.empty()) return false;
    const Name file = take_name(include, 0);
    const std::string path = executor_.find_quietly(file);
    if (path.empty() || !begins_with_parameter(path)) return false;
    const auto source = executor_.open(file);
    executor_.opened(source);
    auto parameters = std::make_shared<SourceFile>(*source);
    parameters->text = std::make_shared<const std::string>("Parameters " + *source->text);
    parse_file(parameters, [&](Statement& more) {
        if (more.name != "Parameters")
            throw InputError(more.where, "parameters and directives in one file");
        std::move(more.arguments.begin(), more.arguments.end(),
                  std::back_inserter(before.arguments));
    });
    std::move(include.arguments.begin() + 1, include.arguments.end(),
              std::back_inserter(before.arguments));
    return true;
}

void Translator::translate(Statement& statement) {
    last_ = statement.where;
    if (ended_) {
        if (!std::exchange(told_["end"], true))
            warn(statement.where, "what follows WorldEnd is not read");
        return;
    }
    const auto rule = rules().find(statement.name);
    if (rule == rules().end()) {
        const std::string message = "unknown directive " + in_quotes(statement.name);
        const std::string nearest = nearest_name(statement.name, names_of(rules()));
        throw InputError(statement.where,
                         nearest.empty() ? message : message + "; did you mean " + nearest + "?");
    }
    if (rule->second.block == Block::World && !in_world_)
        throw InputError(statement.where, statement.name + " stands after WorldBegin only");
    if (rule->second.block == Block::Options && in_world_)
        throw InputError(statement.where, statement.name + " stands before WorldBegin only");
    if (!is_curve(statement)) write_curves();
    (this->*rule->second.method)(statement);
}

void Translator::world_begin(Statement& statement) {
    expect_no_arguments(statement);
    write_options(statement.where);
    add("WorldBegin", statement.where);
    state_.transforms = {};
    state_.active = 3;
    coordinate_systems_["world"] = state_.transforms;
    in_world_ = true;
}

void Translator::world_end(Statement& statement) {
    expect_no_arguments(statement);
    write_curves();
    for (const Scope& scope : scopes_) {
        const char* const word = scope.kind == Scope::Kind::Attribute   ? "AttributeBegin"
                                 : scope.kind == Scope::Kind::Transform ? "TransformBegin"
                                                                        : "ObjectBegin";
        diagnostics_.error(InputError(scope.where, fmt::format("{} is not closed", word)));
    }
    if (in_object_) end_object(statement.where);
    if (!camera_medium_.empty())
        add(NewStatement("Exterior", statement.where).name(camera_medium_));
    add("WorldEnd", statement.where);
    ended_ = true;
}

void Translator::finish() {
    if (ended_) return;
    Statement end{"WorldEnd", last_, {}};
    executor_.guard([&] {
        if (!in_world_) throw InputError(last_, "the scene ends without WorldBegin");
        world_end(end);
    });
}

std::shared_ptr<const SourceFile> Translator::scene_file(Statement& statement) {
    const Name file = take_only_name(statement);
    // Images and meshes are found by their last name too, as in LuxRender; but a part of a scene
    // may be called as the scene is.
    const auto named = std::filesystem::path(file.text).lexically_normal();
    const std::filesystem::path found = executor_.find_quietly(file);
    if (named.has_parent_path() && named.parent_path().filename() != ".." && !found.empty() &&
        found.parent_path().filename() != named.parent_path().filename()) {
        throw IgnoredStatement(file.where,
                               fmt::format("no file {}, but {}, which lies elsewhere",
                                           in_quotes(file.text), in_quotes(found.string())));
    }
    const auto source = executor_.open(file);
    // Messages show lines of scenes, but a scene may name any file of whoever renders it.
    const auto word = first_word(*source->text);
    if (word && !rules().contains(std::string(*word))) {
        throw InputError(file.where, in_quotes(source->name) +
                                         " is no scene file: it does not begin with a directive");
    }
    return source;
}

void Translator::include(Statement& statement) {
    // What stands behind the name goes on with the file's last directive.
    std::vector<Argument> more;
    if (statement.arguments.size() > 1) {
        const auto behind = statement.arguments.begin() + 1;
        more.assign(std::make_move_iterator(behind),
                    std::make_move_iterator(statement.arguments.end()));
        statement.arguments.resize(1);
    }
    read(scene_file(statement), std::move(more));
}

void Translator::import(Statement& statement) {
    const auto source = scene_file(statement);
    // A file with a state of its own, which it leaves as it was.
    const GraphicsState kept = state_;
    read(source);
    write_curves();
    state_ = kept;
}

void Translator::attribute_begin(Statement& statement) {
    expect_no_arguments(statement);
    if (scopes_.size() >= kMostScopes)
        throw EndOfReading(statement.where, fmt::format("more than {} open scopes", kMostScopes));
    scopes_.push_back({Scope::Kind::Attribute, statement.where, state_});
}

void Translator::attribute_end(Statement& statement) {
    expect_no_arguments(statement);
    if (scopes_.empty() || scopes_.back().kind != Scope::Kind::Attribute)
        throw InputError(statement.where, "AttributeEnd without AttributeBegin");
    state_ = std::move(scopes_.back().state);
    scopes_.pop_back();
}

void Translator::transform_begin(Statement& statement) {
    expect_no_arguments(statement);
    if (scopes_.size() >= kMostScopes)
        throw EndOfReading(statement.where, fmt::format("more than {} open scopes", kMostScopes));
    GraphicsState kept;
    kept.transforms = state_.transforms;
    kept.active = state_.active;
    scopes_.push_back({Scope::Kind::Transform, statement.where, std::move(kept)});
}

void Translator::transform_end(Statement& statement) {
    expect_no_arguments(statement);
    if (scopes_.empty() || scopes_.back().kind != Scope::Kind::Transform)
        throw InputError(statement.where, "TransformEnd without TransformBegin");
    state_.transforms = scopes_.back().state.transforms;
    state_.active = scopes_.back().state.active;
    scopes_.pop_back();
}

void Translator::attribute(Statement& statement) {
    static const std::vector<std::string> kTargets{"light", "material", "medium", "shape",
                                                   "texture"};
    const Name target = take_name(statement, 0);
    if (std::find(kTargets.begin(), kTargets.end(), target.text) == kTargets.end())
        throw InputError(target.where,
                         unknown_name_message("target of Attribute", target.text, kTargets));
    ParameterSet set = take_parameters(statement, 1, target);
    ParameterValues& values = state_.defaults[target.text];
    values.insert(values.end(), std::make_move_iterator(set.values.begin()),
                  std::make_move_iterator(set.values.end()));
}

void Translator::option(Statement& statement) {
    const Name none{"", statement.where};
    const ParameterSet set = take_parameters(statement, 0, none);
    // All of them are about how pbrt computes.
    static const std::vector<std::string> kKnown{"debugstart",
                                                 "disablepixeljitter",
                                                 "disabletexturefiltering",
                                                 "disablewavelengthjitter",
                                                 "displacementedgescale",
                                                 "forcediffuse",
                                                 "msereferenceimage",
                                                 "msereferenceout",
                                                 "pixelstats",
                                                 "rendercoordsys",
                                                 "seed",
                                                 "wavefront"};
    for (const ParameterValue& value : set.values) {
        if (std::find(kKnown.begin(), kKnown.end(), value.name) == kKnown.end()) {
            diagnostics_.unknown_parameter(value.where,
                                           unknown_name_message("option", value.name, kKnown));
        } else if (value.name == "forcediffuse" || value.name == "displacementedgescale") {
            warn(value.where, "option " + in_quotes(value.name) + " has no effect here");
        }
    }
}

void Translator::colour_space_directive(Statement& statement) {
    const Name name = take_only_name(statement);
    const ColourSpace* const space = colour_space(name.text);
    if (space == nullptr)
        throw InputError(name.where,
                         unknown_name_message("colour space", name.text, colour_space_names()));
    state_.space = space;
}

void Translator::reverse_orientation(Statement& statement) {
    expect_no_arguments(statement);
    state_.reverse_orientation = !state_.reverse_orientation;
}

void Translator::nothing(Statement& /*statement*/) {}

const ParameterValues& Translator::defaults(const char* target) const {
    static const ParameterValues kNone;
    const auto found = state_.defaults.find(target);
    return found == state_.defaults.end() ? kNone : found->second;
}

Parameters Translator::take(Statement& statement, const char* target) {
    return Parameters(take_plugin(statement), defaults(target), *state_.space, diagnostics_);
}

std::string Translator::fresh(const std::string& stem) {
    const int count = names_[stem]++;
    return count == 0 ? stem : fmt::format("{} #{}", stem, count + 1);
}

}  // namespace lxs::pbrt
