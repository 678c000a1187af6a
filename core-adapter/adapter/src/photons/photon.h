// A photon on its way.
#pragma once

#include "aips/core/base/image_part.h"
#include "photons/constants.h"
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
    std::uint32_t free = 0;   ///< of those met, passed straight, and of no count for its bound
    bool straight = true;     ///< has met nothing but null surfaces and architectural glass
    /// The first surface that did more than let it pass straight sent it on diffusely or glossily.
    bool shareable = false;
    ImagePart part = ImagePart::Direct;  ///< Landing::part where it lands next
    EmissionStart start;

    /// Goes on to the next surface; `straight` tells of the way from the light up to there.
    void pass() {
        if (passes_free()) ++free;
        ++depth;
    }
    /// Whether it would pass one more surface free.
    bool passes_free() const { return straight && free < kMostFreeSurfaces; }
    /// Whether a surface with such lobes is its last: not if it may pass it free.
    bool at_end(const Settings& settings, LobeMask lobes = 0) const {
        return depth - free >= settings.max_photon_depth && !(passes_free() && lobes & kSpecular);
    }
};

}  // namespace aips
