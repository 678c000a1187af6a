// `--set plugin.parameter=value`.
#include "lxs/host/parameter_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lxs/imaging/imaging.h"

namespace lxs {
namespace {

constexpr double kLargest = 3.4e38;  // as in scene files; no infinity and no NaN

/// Lists are parted by spaces or commas.
std::vector<std::string> read_words(const std::string& text) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    while ((begin = text.find_first_not_of(" ,", begin)) != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

std::vector<double> read_numbers(const std::string& text, const SourceLocation& where) {
    std::vector<double> numbers;
    for (const std::string& word : read_words(text)) {
        double number = 0;
        const char* const end = word.data() + word.size();
        const auto [rest, error] = std::from_chars(word.data(), end, number);
        if (error != std::errc() || rest != end || !(std::abs(number) <= kLargest))
            throw InputError(where, "expected a number, found " + in_quotes(word));
        numbers.push_back(number);
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
    if (declaration.type == ParameterType::String && declaration.array) {
        value.values = read_words(text);
    } else if (declaration.type == ParameterType::String) {
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

/// The parts of "plugin.parameter=value".
struct OverrideParts {
    std::string plugin, parameter, value;
};

OverrideParts parts_of(const std::string& text) {
    const std::size_t dot = text.find('.');
    const std::size_t equals = text.find('=');
    return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
}

SourceLocation location_of(const std::string& text) {
    return command_line_location("--set " + text);
}

ParameterValue read_override(const std::string& text,
                             std::span<const ParameterDeclaration> declared) {
    const OverrideParts parts = parts_of(text);
    const SourceLocation where = location_of(text);
    std::vector<std::string> known;
    for (const ParameterDeclaration& declaration : declared) {
        if (declaration.name == parts.parameter) return read_value(declaration, parts.value, where);
        known.emplace_back(declaration.name);
    }
    throw InputError(where, unknown_name_message(fmt::format("{} parameter", parts.plugin),
                                                 parts.parameter, known));
}

void replace(ParameterValue value, ParameterSet& set) {
    std::erase_if(set.values, [&](const ParameterValue& old) { return old.name == value.name; });
    set.values.push_back(std::move(value));
}

}  // namespace

SourceLocation command_line_location(const std::string& option) {
    auto file = std::make_shared<SourceFile>();
    file->name = "command line: " + option;
    return {.file = std::move(file), .line = 0, .column = 0};
}

bool is_sampler_override(const std::string& text) {
    return !sampler_parameters(parts_of(text).plugin).empty();
}

void apply_override(const std::string& text, std::span<const ParameterDeclaration> declared,
                    ParameterSet& set) {
    replace(read_override(text, declared), set);
}

void apply_overrides(const std::vector<std::string>& overrides, const PluginLibrary& plugins,
                     ParameterSet& set, Log& log) {
    for (const std::string& text : overrides) {
        if (is_sampler_override(text)) continue;
        const std::string plugin = parts_of(text).plugin;
        const LoadedIntegrator* loaded = plugins.find(plugin);
        if (loaded == nullptr) {
            throw InputError(location_of(text),
                             unknown_name_message("integrator", plugin, plugins.names()));
        }
        ParameterValue value = read_override(text, loaded->plugin->parameters);
        if (plugin != set.plugin) {
            log.warning(
                fmt::format("--set {} has no effect: the integrator is \"{}\"", text, set.plugin));
            continue;
        }
        replace(std::move(value), set);
    }
}

}  // namespace lxs
