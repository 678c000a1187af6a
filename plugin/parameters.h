// The integrators' parameters, made from the table of settings (aips/adapter/settings_table.h).
#pragma once

#include <span>

#include "aips/adapter/settings.h"
#include "lxs/sdk/parameters.h"

namespace aips {

/// Which plugin name is being set up.
enum class PluginKind { Aips, Sppm, Ppm, ExPhotonMap };

/// What a plugin takes where a scene says nothing: LuxRender's plugins have its values where ours
/// decides itself.
Settings defaults_of(PluginKind kind);

/// Declared parameters of the plugin.
std::span<const lxs::ParameterDeclaration> parameter_declarations(PluginKind kind);

/// Settings from a scene's parameters; the baselines fix guide and mode.
Settings read_settings(PluginKind kind, const lxs::ParameterReader& parameters);

}  // namespace aips
