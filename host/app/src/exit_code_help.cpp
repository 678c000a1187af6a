// What a program's `--help` says of its exit codes.
#include "lxs/host/exit_code_help.h"

#include <fmt/format.h>

namespace lxs {

std::string exit_code_help(std::span<const ExitCodeMeaning> codes) {
    std::string text = "Exit codes:\n";
    for (const auto& [code, meaning] : codes)
        text += fmt::format("  {:>3}  {}\n", code, meaning);
    return text;
}

}  // namespace lxs
