// Which plugin an option statement of the scene chooses.
#include "option_choice.h"

#include <fmt/format.h>

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
        throw InputError(choice.statement.parameters.where,
                         unknown_name_message(statement, plugin, std::vector<std::string>(known)));
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
