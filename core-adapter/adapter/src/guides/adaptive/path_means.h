// What photon paths contribute, and cost, as they are shot now.
//
// A guide that learns divides the mean score of a path by thousands: its power is divided by the
// density of its start, and a score is a square. Old paths are therefore forgotten far sooner here
// than by what is learned of places, which doesn't depend on power: a mean that early paths still
// dominate makes all survival by score too small.
#pragma once

#include <algorithm>

#include "aips/core/base/state_archive.h"
#include "aips/core/tables/constants.h"

namespace aips {

class PathMeans {
  public:
    /// A scored photon path; `cost` in rays.
    void add(double score, double cost) {
        score_ += score;
        cost_ += cost;
        count_ += 1;
    }
    /// After `paths` further scored photon paths: a quarter of all so far, kShortMemoryPaths at
    /// most, count in full from here on.
    void update(double paths) {
        all_ += paths;
        const double memory = std::min(kShortMemoryPaths, 0.25 * all_);
        if (!(memory > 0)) return;
        const double kept = memory / (memory + paths);
        score_ *= kept;
        cost_ *= kept;
        count_ *= kept;
    }
    /// Mean cost over mean score; 0 before any path was worth something.
    double cost_over_score() const { return score_ > 0 ? cost_ / score_ : 0; }
    /// Mean score times mean cost: the error of equal-time images, about; 0 before any path.
    double score_times_cost() const { return count_ > 0 ? score_ * cost_ / (count_ * count_) : 0; }

    /// What was counted counts for no more than `paths`.
    void fade(double paths) {
        all_ = std::min(all_, paths);
        const double kept = count_ > 0 ? std::min(1.0, 0.25 * all_ / count_) : 1;
        for (double* sum : {&score_, &cost_, &count_})
            *sum *= kept;
    }

    /// Saves or restores what was counted.
    void state(StateArchive& archive) {
        for (double* sum : {&score_, &cost_, &count_, &all_})
            archive.amount(*sum);
    }

  private:
    double score_ = 0, cost_ = 0, count_ = 0;
    double all_ = 0;
};

}  // namespace aips
