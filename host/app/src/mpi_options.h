// Options of renders by several processes.
#pragma once

#include <CLI/CLI.hpp>

#include "lxs/host/command_line.h"

namespace lxs {

/// Adds --mpi and --mpi-split; after --explain.
void add_mpi_options(CLI::App& app, CommandLine& command);

/// What can't be told from the options one by one. Throws CLI::ValidationError.
void check_mpi(const CommandLine& command);

}  // namespace lxs
