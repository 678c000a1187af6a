// `--width`, `--height`, `--layers`, `--sampler` and `--set` of a sampler: options that stand above
// the scene's own statements.
#include "lxs/host/statement_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lxs/host/parameter_override.h"
#include "lxs/imaging/imaging.h"
#include "lxs/imaging/layer_names.h"

namespace lxs {
namespace {

/// LuxRender's, where a scene says nothing.
constexpr double kDefaultWidth = 800, kDefaultHeight = 600;

/// The last number given as `name`, if it is one that an image can have; whatever else stands there
/// is for the film to complain of.
double read_size(const ParameterSet& set, std::string_view name, double fallback) {
    double size = fallback;
    for (const ParameterValue& value : set.values) {
        const auto* numbers = std::get_if<std::vector<double>>(&value.values);
        if (value.name == name && numbers != nullptr && numbers->size() == 1)
            size = numbers->front();
    }
    return size;
}

/// In place of what the scene gives as `name`.
template <class Values>
void set_values(ParameterSet& set, const std::string& type, const std::string& name, Values values,
                const SourceLocation& where) {
    std::erase_if(set.values, [&](const ParameterValue& value) { return value.name == name; });
    ParameterValue value;
    value.type = type;
    value.name = name;
    value.where = where;
    value.values = std::move(values);
    set.values.push_back(std::move(value));
}

void set_size(ParameterSet& set, const std::string& name, double size,
              const SourceLocation& where) {
    set_values(set, "integer", name, std::vector<double>{size}, where);
}

/// The statement `name`, made if the scene has none.
ParameterSet& statement(SceneContents& contents, const std::string& name,
                        const std::string& plugin) {
    auto& parameters = contents.options[name].parameters;
    if (parameters.plugin.empty()) {
        parameters.plugin = plugin;
        parameters.where = contents.end;
    }
    return parameters;
}

void set_width(std::uint32_t width, SceneContents& contents) {
    ParameterSet& film = statement(contents, "Film", "fleximage");
    const double old_width = read_size(film, "xresolution", kDefaultWidth);
    const double old_height = read_size(film, "yresolution", kDefaultHeight);
    if (!(old_width >= 1) || !(old_height >= 1)) return;
    const SourceLocation where = command_line_location(fmt::format("--width {}", width));
    set_size(film, "xresolution", width, where);
    set_size(film, "yresolution", std::max(1.0, std::round(old_height * width / old_width)), where);
}

void set_height(std::uint32_t height, SceneContents& contents) {
    set_size(statement(contents, "Film", "fleximage"), "yresolution", height,
             command_line_location(fmt::format("--height {}", height)));
}

void set_layers(const std::string& names, SceneContents& contents) {
    set_values(statement(contents, "Film", "fleximage"), "string", "layers",
               split_layer_names(names), command_line_location("--layers " + names));
}

void choose_sampler(const CommandLine& command, SceneContents& contents) {
    ParameterSet& sampler = statement(contents, "Sampler", *command.sampler);
    if (sampler.plugin != *command.sampler) sampler.values.clear();
    sampler.plugin = *command.sampler;
    sampler.where = command_line_location("--sampler " + *command.sampler);
}

void set_sampler_parameters(const CommandLine& command, SceneContents& contents, Log& log) {
    for (const std::string& text : command.overrides) {
        if (!is_sampler_override(text)) continue;
        const std::string sampler = text.substr(0, text.find('.'));
        const auto chosen = contents.options.find("Sampler");
        if (chosen == contents.options.end() || chosen->second.parameters.plugin != sampler) {
            log.warning(fmt::format("--set {} has no effect: the sampler is another", text));
            continue;
        }
        apply_override(text, sampler_parameters(sampler), chosen->second.parameters);
    }
}

}  // namespace

void apply_statement_overrides(const CommandLine& command, SceneContents& contents, Log& log) {
    if (command.width) set_width(*command.width, contents);
    if (command.height) set_height(*command.height, contents);
    if (command.layers) set_layers(*command.layers, contents);
    if (command.sampler) choose_sampler(command, contents);
    set_sampler_parameters(command, contents, log);
}

}  // namespace lxs
