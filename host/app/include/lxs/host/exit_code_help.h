// What a program's `--help` says of its exit codes.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lxs {

/// One exit code, of whichever program's enumeration.
struct ExitCodeMeaning {
    int code;
    std::string_view meaning;

    template <class Code>
    constexpr ExitCodeMeaning(Code of, std::string_view means)
        : code(static_cast<int>(of)), meaning(means) {}
};

/// A headline and one line per code.
std::string exit_code_help(std::span<const ExitCodeMeaning> codes);

}  // namespace lxs
