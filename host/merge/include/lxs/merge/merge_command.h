// The command lxsmerge.
#pragma once

#include <array>

#include "lxs/host/exit_code.h"

namespace lxs {

inline constexpr std::array kMergeExitCodes = {
    ExitCodeMeaning{ExitCode::Success, "the image is written"},
    ExitCodeMeaning{ExitCode::InternalError, "internal error or out of memory"},
    ExitCodeMeaning{ExitCode::Usage, "the command line is not understood"},
    ExitCodeMeaning{ExitCode::BadInput, "an image can't be read, or does not belong to the others"},
    ExitCodeMeaning{ExitCode::OutputFailure, "an output file can't be written"},
};

/// Reads the images, merges and writes; says what it did, or why not, on standard error.
ExitCode run_lxsmerge(int argc, const char* const* argv);

}  // namespace lxs
