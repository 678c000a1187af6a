// What a scene requires of the engine; everything else is never run.
//
// Decided from the scene and the settings before any ray is traced. What only passes can tell is in
// skip_log and in the parts themselves; docs/understand/costs.md lists all of it.
#pragma once

#include <string>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/adapter/settings.h"

namespace aips {

struct Needs {
    bool photons = true;  ///< some visible point can take light that only photons bring
    /// As asked for, but that guides, or parts of them, that can't help are off.
    Settings settings;
    std::vector<std::string> skipped;  ///< one sentence for each part left out, with its reason
};

/// Before any ray is traced.
Needs analyse(const Scene& scene, const Settings& settings);

}  // namespace aips
