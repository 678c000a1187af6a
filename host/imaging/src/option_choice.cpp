// Which plugin an option statement of the scene chooses.
#include "option_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lxs {

OptionChoice choose_option(const SceneContents& contents, const std::string& statement,
                           std::string_view fallback, std::initializer_list<std::string> known) {
    OptionChoice choice;
    const auto found = contents.options.find(statement);
    if (found == contents.options.end()) {
        choice.statement.parameters.plugin = fallback;
        choice.statement.parameters.where = contents.end;
        return choice;
    }
    choice.statement = found->second;
    choice.given = true;
    const std::string& plugin = choice.statement.parameters.plugin;
    if (std::find(known.begin(), known.end(), plugin) == known.end()) {
        std::string message = fmt::format("unknown {} {}; known: {}", statement, in_quotes(plugin),
                                          fmt::join(known, ", "));
        const std::string near = nearest_name(plugin, std::vector<std::string>(known));
        if (!near.empty()) message += fmt::format("; did you mean \"{}\"?", near);
        throw InputError(choice.statement.parameters.where, message);
    }
    return choice;
}

OptionChoice choose_option(const SceneContents& contents, const std::string& statement,
                           std::string_view fallback, std::initializer_list<std::string> known,
                           Diagnostics& diagnostics) {
    try {
        return choose_option(contents, statement, fallback, known);
    } catch (const InputError& error) {
        diagnostics.fallback(error.where(), error.message(),
                             fmt::format("\"{}\" is used", fallback));
        OptionChoice choice;
        choice.statement = contents.options.at(statement);
        choice.statement.parameters.plugin = fallback;
        choice.given = true;
        return choice;
    }
}

}  // namespace lxs
