// A photon on its way.
#pragma once

#include "aips/core/base/image_part.h"
#include "photons/constants.h"
#include "photons/photon_path.h"

namespace aips {

/// A photon between two surfaces.
struct PhotonState {
    Ray ray;
    Rgb power;
    Vec3 previous;                      ///< where it last left a surface or the light
    float emitted_power = 0;            ///< largest component; roulette by power compares with it
    std::uint32_t group = 0;            ///< of its light
    std::uint32_t depth = 1;            ///< number of the surface that it meets next
    std::uint32_t passed_straight = 0;  ///< of those met, next to the light, of no count for that
    std::uint32_t specular = 0;         ///< likewise, of those whose lobes all are specular
    std::uint32_t bounces = 0;          ///< scatterings that were not straight
    bool from_specular = false;         ///< a specular lobe of the last surface sent it on
    bool straight = true;  ///< has met nothing but null surfaces and architectural glass
    /// The first surface that did more than let it pass straight sent it on diffusely or glossily.
    bool shareable = false;
    ImagePart part = ImagePart::Direct;  ///< Photon::part where it lands next
    EmissionStart start;

    /// Goes on from a surface with such lobes to the next, `straight` telling of the way from the
    /// light up to there.
    void pass(const Settings& settings, LobeMask lobes) {
        if (passes_straight()) {
            ++passed_straight;
        } else if (passes_specular(settings, lobes)) {
            ++specular;
        }
        ++depth;
    }
    /// Whether a surface with such lobes, which it passes straight or not, is its last: not if that
    /// one does not count.
    bool at_end(const Settings& settings, LobeMask lobes, bool straight_on) const {
        return depth - passed_straight - specular >= photon_depth(settings).surfaces &&
               !(straight_on && passes_straight()) && !passes_specular(settings, lobes);
    }
    /// Whether what one more scattering sends on would have too many before the eye: one is the
    /// visible point's.
    bool is_spent(const Settings& settings) const { return bounces + 2 > settings.max_bounces; }

  private:
    bool passes_straight() const { return straight && passed_straight < kMostFreeSurfaces; }
    bool passes_specular(const Settings& settings, LobeMask lobes) const {
        return lobes == kSpecular && specular < photon_depth(settings).specular;
    }
};

}  // namespace aips
