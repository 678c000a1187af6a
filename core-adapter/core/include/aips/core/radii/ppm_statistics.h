// Shared statistics of progressive photon mapping, for one visible point.
// Source: Hachisuka, Ogaki & Jensen 2008, eq. 7-11; Hachisuka & Jensen 2009 (shared by a pixel).
#pragma once

#include <cstdint>

namespace aips {

/// What a pass leaves at a visible point (or at the pixel that shares its statistics).
struct PpmStep {
    double photons = 0;  ///< N: photons kept so far (a real number)
    /// Kept of all photons within the radius, in (0, 1]: the radius's square shrinks by it so that
    /// their density stays (eq. 9), and the flux tau with it (eq. 10).
    double share = 1;
};

/// After a pass that brought `new_photons` (M) to a point with `photons` (N >= 0) kept before: the
/// share `alpha` in (0, 1] of the new ones is kept. Photons that the Bsdf rejects or that are not
/// valid add no light and must not shrink the radius: the caller does not count them.
constexpr PpmStep ppm_step(double photons, std::uint64_t new_photons, double alpha) {
    if (new_photons == 0) return {photons, 1};
    const double kept = photons + alpha * double(new_photons);
    return {kept, kept / (photons + double(new_photons))};
}

}  // namespace aips
