// Fuzz target: settings of the integrator plugins, from the scene's statements and from the command
// line. Lines that begin with "-" are arguments, one a line; the others are statements before
// WorldBegin.
#include <cstdlib>

#include "fuzz_target.h"
#include "input_files.h"
#include "input_plugins.h"
#include "lxs/host/integrator_choice.h"
#include "lxs/host/statement_override.h"
#include "lxs/language/read_scene.h"

namespace {

class SilentLog final : public lxs::Log {
  public:
    void info(std::string_view) override {}
    void warning(std::string_view) override {}
    void debug(std::string_view) override {}
};

/// The arguments among the lines; the rest goes to `statements`.
std::vector<std::string> take_arguments(std::string_view text, std::string& statements) {
    std::vector<std::string> arguments{"lxsrender"};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.starts_with('-') && line.find('\0') == std::string::npos) {
            arguments.push_back(line);
        } else {
            statements += line + '\n';
        }
    }
    arguments.emplace_back("scene.lxs");
    return arguments;
}

void choose(const lxs::CommandLine& command, const std::string& statements) {
    fuzz::SilentDiagnostics diagnostics;
    SilentLog log;
    lxs::SceneContents contents =
        lxs::read_scene_text(statements + "WorldBegin WorldEnd", "scene.lxs",
                             fuzz::folder().path().string(), fuzz::registry(), diagnostics);
    lxs::apply_statement_overrides(command, contents, log);
    const lxs::IntegratorChoice choice =
        lxs::choose_integrator(command, contents, fuzz::plugins(), diagnostics, log);
    const lxs::ParameterReader reader(choice.parameters, choice.integrator->plugin->parameters,
                                      diagnostics);
    if (!lxs::create_integrator(*choice.integrator, reader)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string statements;
    const std::vector<std::string> arguments =
        take_arguments({reinterpret_cast<const char*>(data), data ? size : 0}, statements);
    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    lxs::CommandLine command;
    if (lxs::parse_command_line(static_cast<int>(argv.size()), argv.data(), command)) return 0;
    try {
        choose(command, statements);
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
