// What a scene requires of the engine; everything else is never run.
#pragma once

#include <string>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/adapter/settings.h"

namespace aips {

/// Decided from the scene and the settings, and once more after the first eye pass.
struct Needs {
    bool photons = true;  ///< some visible point can take light that only photons bring
    bool guide = true;    ///< directions are worth guiding
    std::vector<std::string> skipped;  ///< one sentence for each part left out, with its reason
};

/// Before any ray is traced.
Needs analyse(const Scene& scene, const Settings& settings);

}  // namespace aips
