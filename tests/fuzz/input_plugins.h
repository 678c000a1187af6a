// The integrator plugins of this build, for targets that need them.
#pragma once

#include "lxs/host/plugin_library.h"

namespace fuzz {

/// All of them; loaded once.
const lxs::PluginLibrary& plugins();

}  // namespace fuzz
