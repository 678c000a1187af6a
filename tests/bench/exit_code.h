// Exit codes of aips-bench: `--help` and docs/benchmark.md say the same.
#pragma once

#include <array>
#include <string_view>

namespace bench {

enum class ExitCode : int {
    Success = 0,
    InternalError = 1,
    Usage = 2,
    BadInput = 3,
    PluginFailure = 4,
    OutputFailure = 5,
    RunsFailed = 6,
    ReferencesDiffer = 7,
    Interrupted = 130
};

struct ExitCodeMeaning {
    ExitCode code;
    std::string_view meaning;
};

inline constexpr std::array kExitCodes = {
    ExitCodeMeaning{ExitCode::Success, "done"},
    ExitCodeMeaning{ExitCode::InternalError, "internal error"},
    ExitCodeMeaning{ExitCode::Usage, "the command line is not understood"},
    ExitCodeMeaning{ExitCode::BadInput,
                    "unknown scene, method or parameter, or a file that is damaged or of another "
                    "study"},
    ExitCodeMeaning{ExitCode::PluginFailure, "a plugin module can't be loaded"},
    ExitCodeMeaning{ExitCode::OutputFailure, "an output file can't be written"},
    ExitCodeMeaning{ExitCode::RunsFailed, "some runs failed; the others are complete"},
    ExitCodeMeaning{ExitCode::ReferencesDiffer,
                    "the two references of a scene differ by more than chance"},
    ExitCodeMeaning{ExitCode::Interrupted, "interrupted; what was complete is kept"},
};

}  // namespace bench
