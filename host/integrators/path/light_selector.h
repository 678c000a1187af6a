// Chooses which lights a path vertex asks for direct light.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "lxs/sdk/light.h"
#include "path/path_settings.h"

namespace lxs {

/// A light and the probability with which it was chosen.
struct LightChoice {
    const Light* light = nullptr;
    float probability = 1;
};

/// A discrete distribution over the lights that have power.
class LightSelector {
  public:
    LightSelector(std::span<const Light* const> lights, LightStrategy strategy);

    /// Number of choices to make at a vertex: all lights, or one, or none.
    std::size_t choices() const { return all_ ? lights_.size() : std::size_t{!lights_.empty()}; }
    /// The i-th choice; `u` in [0,1) draws it unless all lights are asked.
    LightChoice choose(std::size_t i, float u) const;
    /// Probability that `choose` gives this light; 0 for a light that it never gives.
    float probability(const Light* light) const;
    /// Lights that a ray which leaves the scene sees.
    std::span<const Light* const> at_infinity() const { return at_infinity_; }

  private:
    bool all_;
    std::vector<LightChoice> lights_;
    std::vector<float> cumulative_;  ///< of the probabilities, from 0 to 1
    std::unordered_map<const Light*, float> probability_;
    std::vector<const Light*> at_infinity_;
};

}  // namespace lxs
