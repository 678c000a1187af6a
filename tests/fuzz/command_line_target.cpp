// Fuzz target: the command line, one argument a line, from the arguments to the checked options.
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "fuzz_target.h"
#include "lxs/host/command_line.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> arguments{"lxsrender"};
    std::string word;
    for (std::size_t i = 0; i < size; ++i) {
        if (data[i] == '\n' || data[i] == '\0') {
            arguments.push_back(std::exchange(word, {}));
        } else {
            word.push_back(static_cast<char>(data[i]));
        }
    }
    if (!word.empty()) arguments.push_back(word);
    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    lxs::CommandLine command;
    const auto done = lxs::parse_command_line(static_cast<int>(argv.size()), argv.data(), command);
    if (done) return 0;
    // What has passed the checks is within their bounds.
    if (command.threads > 1024 || command.width.value_or(1) > 65536 ||
        command.height.value_or(1) > 65536 || command.width.value_or(1) == 0 ||
        command.seconds.value_or(1) <= 0 || command.passes.value_or(1) == 0)
        std::abort();
    return 0;
}
