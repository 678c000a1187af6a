// Exit codes of lxsrender: `--help` and docs/reference/errors/index.md say the same.
#pragma once

#include <array>

#include "lxs/host/exit_code_help.h"

namespace lxs {

enum class ExitCode : int {
    Success = 0,
    InternalError = 1,
    Usage = 2,
    BadInput = 3,
    PluginFailure = 4,
    OutputFailure = 5,
    CheckpointRefused = 6,
    Interrupted = 130
};

inline constexpr std::array kExitCodes = {
    ExitCodeMeaning{ExitCode::Success, "the image is written"},
    ExitCodeMeaning{ExitCode::InternalError, "internal error or out of memory"},
    ExitCodeMeaning{ExitCode::Usage, "the command line is not understood"},
    ExitCodeMeaning{
        ExitCode::BadInput,
        "bad scene, a bad value given by --set or --integrator, or a file that --learned-in "
        "can't use"},
    ExitCodeMeaning{ExitCode::PluginFailure, "a plugin module can't be loaded, or fails"},
    ExitCodeMeaning{ExitCode::OutputFailure, "an output file can't be written"},
    ExitCodeMeaning{ExitCode::CheckpointRefused,
                    "a checkpoint can't be resumed, or would be replaced"},
    ExitCodeMeaning{ExitCode::Interrupted, "interrupted; the passes so far are written"},
};

}  // namespace lxs
