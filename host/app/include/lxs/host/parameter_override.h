// `--set plugin.parameter=value`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lxs/host/plugin_library.h"
#include "lxs/sdk/log.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

/// A place on the command line, as messages show it: "command line: --set aips.guide=paper".
SourceLocation command_line_location(const std::string& option);

/// Whether `text` names a sampler that has parameters ("metropolis.maxconsecrejects=0"); all other
/// overrides are for integrators.
bool is_sampler_override(const std::string& text);

/// Puts an override (`text`) into `set`, instead of what `set` has by that name. Throws InputError
/// for a parameter that isn't `declared` and for a value that does not read as its type.
void apply_override(const std::string& text, std::span<const ParameterDeclaration> declared,
                    ParameterSet& set);

/// Puts the overrides that name the chosen integrator (`set.plugin`) into its parameters; those of
/// other integrators are said to have no effect, those of samplers are left alone. Throws
/// InputError for unknown plugins and parameters and for values that do not read as the parameter's
/// type.
void apply_overrides(const std::vector<std::string>& overrides, const PluginLibrary& plugins,
                     ParameterSet& set, Log& log);

}  // namespace lxs
