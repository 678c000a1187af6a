// Whether what a module says of itself can be relied on.
#pragma once

#include <filesystem>

#include "lxs/sdk/plugin.h"

namespace lxs {

/// Throws PluginFailure, naming `file`, unless the module has this program's ABI version, and
/// integrators and parameters with names of their own, spans and texts of believable size, ranges
/// the right way round and defaults that fit them. A wrong pointer can't be told from a right one.
void check_module(const PluginModule* module, const std::filesystem::path& file);

}  // namespace lxs
