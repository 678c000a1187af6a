// The override that makes a photon method write what photons carry as layers of their own.
#pragma once

#include <string>
#include <vector>

#include "lxs/host/plugin_library.h"

namespace bench {

/// Adds `integrator`.debuglayers=true if the integrator declares that parameter.
void add_photon_part(const std::string& integrator, const lxs::PluginLibrary& plugins,
                     std::vector<std::string>& overrides);

}  // namespace bench
