// Prints what there is: `--list-plugins` and `--describe`.
#pragma once

#include <string>
#include <vector>

#include "lxs/host/plugin_library.h"

namespace lxs {

/// Integrators with their sentence and module, one a line.
std::string list_plugins(const PluginLibrary& plugins);

/// Declared parameters of everything that is called `name`: integrators, materials, shapes,
/// cameras, films, ...; and the names of a kind of statement ("Material", "Texture"). Empty if
/// nothing is called so.
std::string describe_plugin(const std::string& name, const PluginLibrary& plugins, bool markdown);

/// The kinds of statement that describe_plugin() knows, in their order.
std::vector<std::string> described_kinds(const PluginLibrary& plugins);

/// All names that describe_plugin() knows, in their order.
std::vector<std::string> describable_names(const PluginLibrary& plugins);

}  // namespace lxs
