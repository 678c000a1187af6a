// A render in a process of its own, so that its memory, CPU time and crashes are its own.
#pragma once

#include <filesystem>
#include <string>

#include "run_settings.h"

namespace bench {

/// How a process ended.
struct ProcessEnd {
    bool done = false;
    bool interrupted = false;  ///< by SIGINT or SIGTERM
    std::string message;       ///< unless done: exit code or signal, and the end of its log
};

/// Runs `program render-one JOB.json` to its end; what it says goes to `log`. The job file stands
/// beside the job's result and is removed. Throws lxs::OutputFailure, and std::system_error if no
/// process can be started.
ProcessEnd render_in_process(const std::filesystem::path& program, const RenderJob& job,
                             const std::filesystem::path& log);

/// The running executable.
std::filesystem::path own_executable();

}  // namespace bench
