// What a pass has cost, counted.
#pragma once

#include <cstdint>

#include "photons/photon_pass.h"

namespace aips {

/// Work of a pass, counted and not measured: bits do not depend on clocks. Any unit.
struct PassWork {
    double eye = 0;  ///< independent of the number of photons
    /// Proportional to it; what a guide learns from, a part of it, becomes less with time.
    double photons = 0;
    double beams = 0;  ///< the same of gathering photons in media
};

/// Work of a pass with so many eye paths, which traced `eye_rays`, and with the photons counted
/// between `before` and `after`. Unit: about 0.3 us.
PassWork pass_work(std::uint64_t eye_paths, std::uint64_t eye_rays, const PhotonPassTotals& before,
                   const PhotonPassTotals& after);

/// Work of a pass that shoots, for its visible points, besides that of its photons.
double shooting_work(double points);

/// Work of so many rays of eye paths, in the same unit.
double eye_ray_work(double rays);

}  // namespace aips
