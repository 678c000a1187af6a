// A photon on its way.
#pragma once

#include "aips/core/base/image_part.h"
#include "photons/photon_path.h"

namespace aips {

/// A photon between two surfaces.
struct Photon {
    Ray ray;
    Rgb power;
    Vec3 previous;            ///< where it last left a surface or the light
    float emitted_power = 0;  ///< largest component; roulette by power compares with it
    std::uint32_t group = 0;  ///< of its light
    std::uint32_t depth = 1;  ///< number of the surface that it meets next
    bool straight = true;     ///< has met nothing but null surfaces and architectural glass
    /// The first surface that did more than let it pass straight sent it on diffusely or glossily.
    bool shareable = false;
    ImagePart part = ImagePart::Direct;  ///< Landing::part where it lands next
    EmissionStart start;
};

}  // namespace aips
