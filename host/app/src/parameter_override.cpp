// `--set plugin.parameter=value`.
#include "lxs/host/parameter_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace lxs {
namespace {

std::vector<double> read_numbers(const std::string& text, const SourceLocation& where) {
    std::vector<double> numbers;
    std::size_t begin = 0;
    while ((begin = text.find_first_not_of(" ,", begin)) != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
        double number = 0;
        const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, number);
        if (error != std::errc() || rest != text.data() + end) {
            throw InputError(
                where, "expected a number, found " + in_quotes(text.substr(begin, end - begin)));
        }
        numbers.push_back(number);
        begin = end;
    }
    return numbers;
}

/// Type name as a scene file would write it.
std::string written_type(ParameterType type) {
    switch (type) {
        case ParameterType::Float:
        case ParameterType::FloatTexture:
        case ParameterType::FresnelTexture:
            return "float";
        case ParameterType::Integer:
            return "integer";
        case ParameterType::Bool:
            return "bool";
        case ParameterType::String:
            return "string";
        case ParameterType::Color:
        case ParameterType::ColorTexture:
            return "color";
        case ParameterType::Point:
            return "point";
        case ParameterType::Vector:
            return "vector";
        case ParameterType::Normal:
            break;
    }
    return "normal";
}

ParameterValue read_value(const ParameterDeclaration& declaration, const std::string& text,
                          const SourceLocation& where) {
    ParameterValue value;
    value.type = written_type(declaration.type);
    value.name = declaration.name;
    value.where = where;
    if (declaration.type == ParameterType::String) {
        value.values = std::vector<std::string>{text};
    } else if (declaration.type == ParameterType::Bool) {
        if (text != "true" && text != "false") {
            throw InputError(where, "expected true or false, found " + in_quotes(text));
        }
        value.values = std::vector<bool>{text == "true"};
    } else {
        value.values = read_numbers(text, where);
    }
    return value;
}

const ParameterDeclaration& find_declaration(const IntegratorPlugin& plugin,
                                             const std::string& name, const SourceLocation& where) {
    std::vector<std::string> known;
    for (const ParameterDeclaration& declaration : plugin.parameters) {
        if (declaration.name == name) return declaration;
        known.emplace_back(declaration.name);
    }
    throw InputError(where,
                     unknown_name_message(fmt::format("{} parameter", plugin.name), name, known));
}

}  // namespace

SourceLocation command_line_location(const std::string& option) {
    auto file = std::make_shared<SourceFile>();
    file->name = "command line: " + option;
    return {.file = std::move(file), .line = 0, .column = 0};
}

void apply_overrides(const std::vector<std::string>& overrides, const PluginLibrary& plugins,
                     ParameterSet& set, Log& log) {
    for (const std::string& text : overrides) {
        const SourceLocation where = command_line_location("--set " + text);
        const std::size_t dot = text.find('.');
        const std::size_t equals = text.find('=');
        const std::string plugin = text.substr(0, dot);
        const LoadedIntegrator* loaded = plugins.find(plugin);
        if (loaded == nullptr) {
            throw InputError(where, unknown_name_message("integrator", plugin, plugins.names()));
        }
        const std::string name = text.substr(dot + 1, equals - dot - 1);
        const ParameterDeclaration& declaration = find_declaration(*loaded->plugin, name, where);
        ParameterValue value = read_value(declaration, text.substr(equals + 1), where);
        if (plugin != set.plugin) {
            log.warning(
                fmt::format("--set {} has no effect: the integrator is \"{}\"", text, set.plugin));
            continue;
        }
        std::erase_if(set.values, [&](const ParameterValue& old) { return old.name == name; });
        set.values.push_back(std::move(value));
    }
}

}  // namespace lxs
