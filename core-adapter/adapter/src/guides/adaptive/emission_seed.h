// Where a photon ought to start.
#pragma once

#include "aips/adapter/scene.h"
#include "aips/core/trees/primary_tree.h"

namespace aips {

/// Found from the eye.
struct EmissionSeed {
    LightIndex light = kNoLight;
    PrimaryPoint point{};
    float weight = 0;  ///< > 0, finite: about the luminance that such light adds to the eye path
};

}  // namespace aips
