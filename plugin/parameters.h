// The integrator's parameters: declared once; parsing, validation, help and the reference page
// (docs/reference/parameters.md) are made from here.
#pragma once

#include <span>

#include "aips/adapter/settings.h"
#include "lxs/sdk/parameters.h"

namespace aips {

/// Which plugin name is being set up.
enum class PluginKind { Aips, Sppm, Ppm, ExPhotonMap };

/// Declared parameters of the plugin.
std::span<const lxs::ParameterDeclaration> parameter_declarations(PluginKind kind);

/// Settings from a scene's parameters; the baselines fix guide and mode.
Settings read_settings(PluginKind kind, const lxs::ParameterReader& parameters);

}  // namespace aips
