// Shared statistics of progressive photon mapping, for one visible point.
// Source: Hachisuka, Ogaki & Jensen 2008, eq. 7-11; Hachisuka & Jensen 2009 (shared by a pixel).
#pragma once

#include <cmath>
#include <cstdint>

#include "aips/core/rgb.h"

namespace aips {

/// Radius, photon count and flux of one visible point (or of the pixel that shares them).
class PpmStatistics {
  public:
    explicit PpmStatistics(float initial_radius) : radius_(initial_radius) {}

    /// A photon within the radius, with f * power. One that the Bsdf rejects (black) adds no light
    /// and must not shrink the radius, so it does not count; nor does one that is not valid.
    void add(Rgb contribution) {
        if (is_black(contribution) || !is_valid_radiance(contribution)) return;
        ++new_photons_;
        new_flux_ += contribution;
    }

    /// At the end of a pass: keeps the share `alpha` in (0, 1] of the new photons, shrinks the
    /// radius so that the density stays, and scales the flux to it.
    void end_pass(float alpha) {
        if (new_photons_ == 0) return;
        const double kept = photons_ + double(alpha) * double(new_photons_);
        const double share = kept / (photons_ + double(new_photons_));
        flux_ = (flux_ + new_flux_) * float(share);
        radius_ *= float(std::sqrt(share));
        photons_ = kept;
        new_photons_ = 0;
        new_flux_ = {};
    }

    float radius() const { return radius_; }
    /// N: photons kept so far (a real number).
    double photons() const { return photons_; }
    /// tau: sum of f * power within the present radius, over all passes.
    Rgb flux() const { return flux_; }

  private:
    float radius_;
    double photons_ = 0;
    std::uint64_t new_photons_ = 0;
    Rgb flux_;
    Rgb new_flux_;
};

}  // namespace aips
