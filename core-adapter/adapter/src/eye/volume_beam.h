// The part of an eye path that crosses a medium which scatters.
#pragma once

#include "aips/adapter/media.h"
#include "aips/core/base/image_part.h"
#include "aips/core/photon_map/photon.h"

namespace aips {

/// A segment of an eye path within one medium.
struct VolumeBeam {
    Vec3 origin;
    Vec3 direction;  ///< unit, away from the eye
    float length = 0;
    const void* medium = nullptr;
    Rgb throughput;  ///< of the eye path at the origin, divided by its choices' probabilities
    std::uint32_t sample = 0;                           ///< index of the eye path in its pass
    EyeScatterings scatterings;                         ///< of the eye path before it
    std::uint16_t photon_bounces = kMostPhotonBounces;  ///< as VisiblePoint::photon_bounces

    Vec3 at(float distance) const { return origin + direction * distance; }
    Ray ray() const { return {.origin = origin, .direction = direction, .medium = medium}; }
};

/// Chooses one of a path's beams, each in proportion to its weight (reservoir sampling).
class BeamChoice {
  public:
    /// Whether a beam of this weight, > 0, is the one so far. `next` gives a number in [0, 1).
    template <class Next>
    bool takes(float weight, const Next& next) {
        const bool first = weights_ == 0;
        weights_ += weight;
        if (!first && next() * weights_ >= weight) return false;
        weight_ = weight;
        return true;
    }
    /// One over the probability of the one that was taken.
    float factor() const { return weights_ / weight_; }

  private:
    float weights_ = 0;  // of all
    float weight_ = 0;   // of the one that is kept
};

/// The density k exp(-k t) / (1 - exp(-k L)) of distances t on a segment of length L.
class SegmentExponential {
  public:
    /// Falls as slowly as the channel that scatters and is dimmed least: the quotient of any
    /// channel's transmittance and the density is bounded.
    SegmentExponential(Rgb extinction, Rgb scattering, float length);

    float sample(float u) const;
    float pdf(float t) const;

  private:
    float rate_, length_;
    float mass_;  // 1 - exp(-k L)
};

}  // namespace aips
