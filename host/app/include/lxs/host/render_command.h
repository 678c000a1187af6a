// Carries out a command line.
#pragma once

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/exit_code.h"
#include "lxs/host/rank_job.h"

namespace lxs {

/// Renders, or lists or describes plugins. Every failure is reported on `log` and becomes an exit
/// code. `job`: of --mpi, else null.
ExitCode carry_out(const CommandLine& command, ConsoleLog& log, RankJob* job = nullptr);

}  // namespace lxs
