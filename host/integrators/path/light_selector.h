// Chooses which lights a path vertex asks for direct light.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "aips/core/tables/learned_lights.h"
#include "lxs/sdk/light.h"
#include "lxs/sdk/state_archive.h"
#include "path/path_settings.h"

namespace lxs {

/// A light and the probability with which it was chosen.
struct LightChoice {
    const Light* light = nullptr;
    float probability = 1;
    std::uint32_t index = 0;  ///< among the lights that have power
};

/// What has been learned of the place of a vertex; null where that is nothing. Valid until the next
/// LightSelector::learn().
using LightTable = const aips::DiscreteDistribution*;

/// A discrete distribution over the lights that have power; with LightStrategy::Learned one for
/// each place, made of what shadow rays found there (docs/understand/direct-light.md).
class LightSelector {
  public:
    /// `scene`: box around the places that are learned of.
    LightSelector(std::span<const Light* const> lights, LightStrategy strategy,
                  const Bounds& scene = {});

    /// Number of choices to make at a vertex: all lights, or one, or none.
    std::size_t choices() const { return all_ ? lights_.size() : std::size_t{!lights_.empty()}; }
    /// Where a vertex is; `n` is a normal on the side that it is seen from.
    LightTable at(const Vec3& p, const Vec3& n) const;
    /// The i-th choice; `u` in [0,1) draws it unless all lights are asked. Without a table it is
    /// the one that needs no place: by power if places are learned of.
    LightChoice choose(std::size_t i, float u, LightTable table = nullptr) const;
    /// Probability that `choose` gives this light; 0 for a light that it never gives.
    float probability(const Light* light, LightTable table = nullptr) const;
    /// Lights that a ray which leaves the scene sees.
    std::span<const Light* const> at_infinity() const { return at_infinity_; }

    /// Whether there are tables that still learn.
    bool learns() const { return learned_ && learned_->learns(); }
    /// Whether anything was learned.
    bool knows() const { return learned_ && learned_->knows(); }
    /// What shadow rays told, as aips::LearnedLights::learn() wants it: to be called between
    /// passes.
    void learn(std::span<const aips::LightSample> samples, std::uint64_t due, std::uint64_t passes);
    /// Saves what was learned, or restores it into a new selector over the same lights.
    void state(StateArchive& archive);
    /// Saves what was learned for another render, or takes it before the first pass: it fades.
    void learned(StateArchive& archive);

  private:
    bool all_;
    std::vector<LightChoice> lights_;
    std::vector<float> cumulative_;                             ///< of probabilities, from 0 to 1
    std::unordered_map<const Light*, std::uint32_t> index_of_;  ///< in lights_
    std::vector<const Light*> at_infinity_;
    std::optional<aips::LearnedLights> learned_;
};

}  // namespace lxs
