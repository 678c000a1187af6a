// --mpi-split passes: each process renders passes of its own with a seed of its own, and what they
// wrote is merged.
#pragma once

#include <cstdint>
#include <string>

#include "lxs/host/command_line.h"

namespace lxs {

/// What process `rank` of `count` does of `asked`: its share of --passes, with the seed that many
/// above, into files whose names have its number. What only one can do, the first does.
CommandLine part_of_render(const CommandLine& asked, std::uint32_t rank, std::uint32_t count);

/// When all parts are written: merges them into what was asked for, and removes them. Says on
/// standard error what it did, or why not; then they stay.
ExitCode merge_parts(const CommandLine& asked, std::uint32_t count);

}  // namespace lxs
