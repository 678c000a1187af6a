// Carries out a command line.
#pragma once

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/exit_code.h"

namespace lxs {

/// Renders, or lists or describes plugins. Every failure is reported on `log` and becomes an exit
/// code.
ExitCode carry_out(const CommandLine& command, ConsoleLog& log);

}  // namespace lxs
