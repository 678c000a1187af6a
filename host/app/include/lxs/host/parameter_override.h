// `--set plugin.parameter=value`.
#pragma once

#include <string>
#include <vector>

#include "lxs/host/plugin_library.h"
#include "lxs/sdk/log.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// A place on the command line, as messages show it: "command line: --set aips.guide=paper".
SourceLocation command_line_location(const std::string& option);

/// Puts the overrides that name the chosen integrator (`set.plugin`) into its parameters; the
/// others are said to have no effect. Throws InputError for unknown plugins and parameters and for
/// values that do not read as the parameter's type.
void apply_overrides(const std::vector<std::string>& overrides, const PluginLibrary& plugins,
                     ParameterSet& set, Log& log);

}  // namespace lxs
