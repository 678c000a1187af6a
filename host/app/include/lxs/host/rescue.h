// Where an output goes that can't be written where it was asked for: no finished pass is thrown
// away while any place takes it.
#pragma once

#include <functional>
#include <string>

#include "lxs/host/console_log.h"

namespace lxs {

/// Writes a whole file to the path it is given, or throws.
using WriteFile = std::function<void(const std::string& path)>;

/// Calls `write` for `path`. If that fails, reports the reason as an error and tries
/// STEM.rescued.SUFFIX (STEM.rescued-2.SUFFIX where there is one already, and so on) in the nearest
/// folder on the way to `path` that is still there, in the current folder and in the system's
/// folder for temporary files; says where the file is then, or that it is lost. True if `path`
/// itself is written.
bool write_or_rescue(const std::string& path, const WriteFile& write, ConsoleLog& log);

}  // namespace lxs
