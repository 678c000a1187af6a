// Checks of statements' arguments.
#include "lxs/language/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lxs {
namespace {

using Strings = std::vector<std::string>;
using Numbers = std::vector<double>;

bool is_type(std::string_view word) {
    const auto types = written_types();
    return std::find(types.begin(), types.end(), word) != types.end();
}

std::string_view kind_of(const Argument& argument) {
    if (argument.bracketed) return "a list";
    if (std::holds_alternative<Numbers>(argument.values)) return "a number";
    return std::holds_alternative<Strings>(argument.values) ? "a string" : "a bool";
}

/// The one string of an argument, brackets or not; null if it is anything else.
const std::string* single_string(const Argument& argument) {
    const auto* strings = std::get_if<Strings>(&argument.values);
    return strings && strings->size() == 1 ? &strings->front() : nullptr;
}

void expect_count(const Statement& statement, std::size_t count) {
    if (statement.arguments.size() <= count) return;
    const Argument& extra = statement.arguments[count];
    throw InputError(extra.where,
                     fmt::format("{} takes no more, found {}", statement.name, kind_of(extra)));
}

/// Numbers that no declaration checks must be finite.
const Numbers& finite_numbers(const Statement& statement, const Argument& argument) {
    const Numbers& numbers = std::get<Numbers>(argument.values);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (std::isfinite(numbers[i])) continue;
        throw InputError(i < argument.value_where.size() ? argument.value_where[i] : argument.where,
                         fmt::format("{} takes finite numbers, at most 3.4e38", statement.name));
    }
    return numbers;
}

/// "type name" split at blanks.
std::vector<std::string> words_of(const std::string& text) {
    constexpr const char* kBlanks = " \t";
    std::vector<std::string> words;
    std::size_t begin = text.find_first_not_of(kBlanks);
    while (begin != std::string::npos) {
        const std::size_t end = text.find_first_of(kBlanks, begin);
        words.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

bool is_parameter_head(const Argument& argument) {
    if (argument.bracketed) return false;
    const std::string* text = single_string(argument);
    if (!text) return false;
    const std::vector<std::string> words = words_of(*text);
    return words.size() == 2 && is_type(words[0]);
}

/// Type and name of a parameter from its string; ParameterReader checks the type.
ParameterValue parameter_head(const Argument& argument) {
    const std::string* text = argument.bracketed ? nullptr : single_string(argument);
    if (!text) {
        throw InputError(argument.where, fmt::format("expected a parameter, \"type name\", found "
                                                     "{}; several values stand in [ ]",
                                                     kind_of(argument)));
    }
    const std::vector<std::string> words = words_of(*text);
    if (words.empty() || words.size() > 2) {
        throw InputError(
            argument.where,
            fmt::format("a parameter begins with \"type name\", found {}", in_quotes(*text)));
    }
    ParameterValue value;
    if (words.size() == 2) value.type = words[0];
    value.name = words.back();
    value.where = argument.where;
    return value;
}

/// LuxRender writes bools as the strings "true" and "false". Other strings stay as they are: the
/// check against the declaration words the error.
void read_bools(ParameterValue& value) {
    const auto* strings = std::get_if<Strings>(&value.values);
    if (!strings) return;
    std::vector<bool> bools;
    for (const std::string& text : *strings) {
        if (text != "true" && text != "false") return;
        bools.push_back(text == "true");
    }
    value.values = std::move(bools);
}

}  // namespace

void expect_no_arguments(const Statement& statement) {
    expect_count(statement, 0);
}

std::vector<double> take_number_list(const Statement& statement) {
    expect_count(statement, 1);
    if (statement.arguments.empty() ||
        !std::holds_alternative<Numbers>(statement.arguments[0].values))
        throw InputError(statement.where, statement.name + " takes numbers");
    return finite_numbers(statement, statement.arguments[0]);
}

std::vector<double> take_numbers(const Statement& statement, std::size_t count) {
    const bool numeric = statement.arguments.size() == 1 &&
                         std::holds_alternative<Numbers>(statement.arguments[0].values);
    const std::size_t found = numeric ? std::get<Numbers>(statement.arguments[0].values).size() : 0;
    if (found != count) {
        throw InputError(statement.where,
                         fmt::format("{} takes {} numbers, found {}", statement.name, count,
                                     numeric || statement.arguments.empty() ? std::to_string(found)
                                                                            : "other arguments"));
    }
    return finite_numbers(statement, statement.arguments[0]);
}

Name take_name(const Statement& statement, std::size_t index) {
    if (index >= statement.arguments.size()) {
        throw InputError(statement.where,
                         fmt::format("{} takes {} in quotes", statement.name,
                                     index == 0 ? "a name" : std::to_string(index + 1) + " names"));
    }
    const Argument& argument = statement.arguments[index];
    const std::string* text = single_string(argument);
    if (!text) {
        throw InputError(argument.where, fmt::format("{} takes a name in quotes here, found {}",
                                                     statement.name, kind_of(argument)));
    }
    return {*text, argument.where};
}

Name take_only_name(const Statement& statement) {
    expect_count(statement, 1);
    return take_name(statement, 0);
}

ParameterSet take_parameters(Statement& statement, std::size_t first, const Name& plugin) {
    ParameterSet set;
    set.plugin = plugin.text;
    set.where = plugin.where;
    std::vector<Argument>& arguments = statement.arguments;
    for (std::size_t i = first; i < arguments.size(); i += 2) {
        ParameterValue value = parameter_head(arguments[i]);
        if (i + 1 == arguments.size() || is_parameter_head(arguments[i + 1])) {
            throw InputError(value.where,
                             fmt::format("parameter {} has no value", in_quotes(value.name)));
        }
        Argument& given = arguments[i + 1];
        const auto* numbers = std::get_if<Numbers>(&given.values);
        if (!given.bracketed && numbers && numbers->size() > 1) {
            throw InputError(given.where, "several values stand in [ ]");
        }
        value.values = std::move(given.values);
        value.value_where = std::move(given.value_where);
        if (value.type == "bool") read_bools(value);
        set.values.push_back(std::move(value));
    }
    return set;
}

ParameterSet take_plugin(Statement& statement) {
    return take_parameters(statement, 1, take_name(statement, 0));
}

}  // namespace lxs
