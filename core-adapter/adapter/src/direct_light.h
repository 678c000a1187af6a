// Next-event estimation at eye vertices, and the densities that weigh it against bounces.
#pragma once

#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/discrete_distribution.h"
#include "aips/core/random.h"
#include "refusals.h"

namespace aips {

/// The eye vertex at which direct light is estimated.
struct DirectLightQuery {
    const SurfacePoint& point;
    Vec3 wo;
    float time = 0;
    Rgb throughput;          ///< of the eye path up to here
    LobeMask owned = 0;      ///< lobes whose direct light belongs to shadow rays alone
    LobeMask shared = 0;     ///< lobes whose bounce can also meet the light (balance heuristic)
    LobeMask bounce = 0;     ///< the mask that the bounce samples: `shared` and specular lobes
    float continue_pdf = 0;  ///< probability that the eye path bounces
};

/// Chooses a light by power and samples one direction towards it.
class DirectLight {
  public:
    explicit DirectLight(const Scene& scene);

    /// Adds the estimate to `radiance`, one entry a light group. Returns shadow rays traced.
    unsigned estimate(const DirectLightQuery& query, RandomStream& random, Refusals& refusals,
                      std::span<Rgb> radiance) const;

    /// Density per steradian with which `estimate` would have drawn the light met by the direction
    /// wi from `from`; `at` is the point met, null for lights at infinity.
    float pdf(LightIndex light, const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const;

    /// Probabilities of the lights to be chosen.
    const DiscreteDistribution& choice() const { return choice_; }

    /// Lights that rays which leave the scene may see, in the scene's order.
    std::span<const LightIndex> at_infinity() const { return at_infinity_; }

  private:
    const Scene& scene_;
    DiscreteDistribution choice_;
    std::vector<LightIndex> at_infinity_;
};

}  // namespace aips
