// What a program says of a command line that it does not understand.
#include "lxs/host/command_line_mistake.h"

#include <fmt/format.h>

#include <algorithm>

#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

/// Without dashes before it and a value behind it.
std::string bare_name(const std::string& argument) {
    const std::size_t first = std::min(argument.find_first_not_of('-'), argument.size());
    return argument.substr(first, argument.find('=') - first);
}

/// Of the program and of the subcommands that were named.
std::vector<std::string> long_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        const std::vector<std::string>& own = option->get_lnames();
        names.insert(names.end(), own.begin(), own.end());
    }
    for (const CLI::App* subcommand : app.get_subcommands()) {
        const std::vector<std::string> own = long_names(*subcommand);
        names.insert(names.end(), own.begin(), own.end());
    }
    return names;
}

/// The first argument that looks like an option and is none; empty if there is none.
std::string unknown_option(const CLI::App& app) {
    const std::vector<std::string> rest = app.remaining(true);
    const auto found = std::find_if(rest.begin(), rest.end(), [](const std::string& argument) {
        return argument.size() > 1 && argument.front() == '-';
    });
    return found == rest.end() ? "" : *found;
}

}  // namespace

std::string mistake_message(const CLI::App* app, const CLI::Error& error) {
    const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    const std::string option = extra ? unknown_option(*app) : "";
    if (option.empty()) return CLI::FailureMessage::simple(app, error);
    const std::string nearest = nearest_name(bare_name(option), long_names(*app));
    return fmt::format("unknown option {}{}\nRun with --help for more information.\n",
                       in_quotes(option.substr(0, option.find('='))),
                       nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest));
}

}  // namespace lxs
