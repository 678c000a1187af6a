// Facts about a scene that decide what of tracing and rendering it needs.
#pragma once

#include <set>

#include "lxs/scene/contents.h"
#include "lxs/sdk/scene.h"
#include "spectral_need.h"

namespace lxs {

/// What tracing itself needs to know beyond SceneFacts.
struct SceneSurvey {
    SceneFacts facts;               ///< facts count stored shapes, instances once
    bool has_straight = false;      ///< some surface may pass light undeviated
    std::set<const Medium*> media;  ///< that surfaces, lights or the camera stand in
    SceneSpectra spectra;
};

/// Looks at all primitives, of objects too. Warns if media scatter and the scene's
/// VolumeIntegrator renders that otherwise than by all its scatterings.
SceneSurvey survey(const SceneContents& contents, Diagnostics& diagnostics);

}  // namespace lxs
