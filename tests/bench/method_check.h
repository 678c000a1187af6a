// Can this build run a method, with these overrides, to the letter?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lxs/host/console_log.h"
#include "lxs/host/plugin_library.h"
#include "method_table.h"

namespace bench {

/// Makes ready a scene of one ball with the method and `overrides`, as a run would; the scene's
/// file stands in `folder` meanwhile. Throws StudyError that names the method: its integrator or
/// sampler is unknown, a parameter is unknown, has a wrong value, or has no effect, so that what is
/// measured would not be what the method's name says.
void check_method(const Method& method, const std::vector<std::string>& overrides,
                  const lxs::PluginLibrary& plugins, const std::filesystem::path& folder,
                  lxs::ConsoleLog& log);

/// Each of `overrides` names an integrator of this build. Throws StudyError.
void check_overrides(const std::vector<std::string>& overrides, const lxs::PluginLibrary& plugins);

}  // namespace bench
