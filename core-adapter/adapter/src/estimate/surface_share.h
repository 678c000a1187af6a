// How much of a gather disc is surface, asked of the scene by rays.
#pragma once

#include <cstdint>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "eye/eye_pass.h"

namespace aips {

/// How a gather disc is asked.
struct SurfaceQuestion {
    std::uint32_t side = 1;  ///< one place in each cell of side x side is tried first
    float believed = 0;      ///< chance of a place to pass for surface unasked, below 1
    float occlusion = 0;     ///< chance of surface to be asked whether something separates it
};

/// Asks for places of gather discs whether there is surface. Not for many threads at once.
class SurfaceShare {
  public:
    /// `scene` and `arena` outlive it; rays travel at `time`. The arena is left as it was.
    SurfaceShare(const Scene& scene, float time, Arena& arena);

    /// By how much photons around `point` have to count for more, the disc of `radius` being no
    /// surface in part: in the mean (1 - p) (1 - (1 - p)^kMostTrials) / p, which is 1 / p - 1 but
    /// for its bound. p is the share of places that pass for surface: those believed unasked, and
    /// those where a ray along the normal finds surface that gather_photons() takes photons from,
    /// turned alike, within the slab, and not separated from the point as far as that is asked.
    /// Exactly 0 where all is surface.
    float missing(const VisiblePoint& point, float radius, const SurfaceQuestion& question,
                  RandomStream& random);

    /// Whether light at `point` counts as lost: with the probability of what photons bring too
    /// little of it in the mean, corrected by missing(). One place is tried first, whatever
    /// question.side is.
    bool loses(const VisiblePoint& point, float radius, const SurfaceQuestion& question,
               RandomStream& random);

    std::uint64_t rays() const { return rays_; }
    /// Whether the last call met surface that something separates from the point.
    bool met_separated() const { return met_separated_; }

  private:
    class Disc;
    /// Whether photons that land at a place of the disc count.
    bool finds(const Disc& disc, Vec2 u, const SurfaceQuestion& question, RandomStream& random);
    bool reaches(const Disc& disc, const SurfacePoint& met);

    const Scene& scene_;
    Arena& arena_;
    Ray ray_;
    std::uint64_t rays_ = 0;
    bool met_separated_ = false;
};

}  // namespace aips
