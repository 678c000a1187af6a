// Exit codes of aips-bench: `--help` and docs/reference/benchmark-files.md say the same.
#pragma once

#include <array>

#include "lxs/host/exit_code_help.h"

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
    MethodsDiffer = 8,
    Interrupted = 130
};

inline constexpr std::array kExitCodes = {
    lxs::ExitCodeMeaning{ExitCode::Success, "done"},
    lxs::ExitCodeMeaning{ExitCode::InternalError, "internal error"},
    lxs::ExitCodeMeaning{ExitCode::Usage, "the command line is not understood"},
    lxs::ExitCodeMeaning{
        ExitCode::BadInput,
        "unknown scene, method or parameter, or a file that is damaged or of another "
        "study"},
    lxs::ExitCodeMeaning{ExitCode::PluginFailure, "a plugin module can't be loaded"},
    lxs::ExitCodeMeaning{ExitCode::OutputFailure, "an output file can't be written"},
    lxs::ExitCodeMeaning{ExitCode::RunsFailed, "some runs failed; the others are complete"},
    lxs::ExitCodeMeaning{ExitCode::ReferencesDiffer,
                         "the two references of a scene differ by more than chance"},
    lxs::ExitCodeMeaning{
        ExitCode::MethodsDiffer,
        "a method differs from the references or the baseline by more than noise and bias"},
    lxs::ExitCodeMeaning{ExitCode::Interrupted, "interrupted; what was complete is kept"},
};

}  // namespace bench
