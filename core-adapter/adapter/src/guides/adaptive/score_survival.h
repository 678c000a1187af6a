// Russian roulette by what a photon may still bring: efficiency-optimal survival probabilities.
//
// A photon of power P that goes on with probability s has a second moment q P^2 / s and a cost of
// c s from there; moment times cost of the whole is least at s = P sqrt((q / c) / (Q / C)), Q and C
// being second moment and cost of a whole path (Rath et al. 2022, "EARS").
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "aips/core/trees/score_cache.h"

namespace aips {

class ScoreSurvival {
  public:
    explicit ScoreSurvival(const ScoreCache& cache) : cache_(&cache) {}

    /// Whole paths' mean cost over mean score; 0: nothing known yet.
    void set_reference(double cost_over_score) { cost_over_score_ = cost_over_score; }

    /// Saves or restores the reference; the cache is saved by itself.
    void state(StateArchive& archive) { archive.amount(cost_over_score_); }

    /// Photons that ought to go on: a probability, or above 1 how many to split into. From what is
    /// known before a direction is drawn: else the choice would undo the guide's. `power`:
    /// luminance, watts, to which it is proportional. Nothing where nothing is known.
    std::optional<float> probability(Vec3 position, Vec3 normal, float power) const {
        if (!(cost_over_score_ > 0)) return std::nullopt;
        const ScoreCache::Expectation expected = cache_->at(position, normal);
        if (!expected.known || !(expected.cost > 0)) return std::nullopt;
        const double ratio = double(expected.score) / double(expected.cost) * cost_over_score_;
        const double photons = double(power) * std::sqrt(ratio);
        // 0 times infinity, where scores have faded beyond a double's range, tells nothing.
        if (std::isnan(photons)) return std::nullopt;
        return float(std::min(photons, double(std::numeric_limits<float>::max())));
    }

  private:
    const ScoreCache* cache_;
    double cost_over_score_ = 0;
};

}  // namespace aips
