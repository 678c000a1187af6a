// Prints what there is: `--list-plugins` and `--describe`.
#pragma once

#include <string>

#include "lxs/host/plugin_library.h"

namespace lxs {

/// Integrators with their sentence and module, one a line.
std::string list_plugins(const PluginLibrary& plugins);

/// Declared parameters of everything that is called `name`: integrators, materials, shapes, ...
/// Empty if nothing is.
std::string describe_plugin(const std::string& name, const PluginLibrary& plugins, bool markdown);

}  // namespace lxs
