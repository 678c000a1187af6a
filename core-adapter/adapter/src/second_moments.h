// Whether a guided density pays: second moment times cost, on samples that did not shape it.
//
// A sample drawn with density p that was worth Q = (f / p)^2 tells the second moment that another
// density p' would give, E_p[Q p / p'], and the cost of its paths, E_p[c p' / p]. Judged on the
// samples that had shaped the density themselves, moments come out too low.
#pragma once

#include <algorithm>

#include "aips/core/state_archive.h"

namespace aips {

class SecondMoments {
  public:
    /// Least gain at which guiding is switched on, and at which it stays on. Moments are noisy,
    /// stratified plain samples do better than theirs, and learning has its price.
    static constexpr double kGain = 1.4, kStayGain = 1.25;

    /// One photon path: worth `score` and costing `cost`, drawn with density `drawn` where the
    /// plain one is `plain` and the guided one `guided` (all > 0); `guide_cost`: of guiding it.
    void add(double score, double cost, double guide_cost, double drawn, double plain,
             double guided) {
        add({score * drawn / plain, cost * plain / drawn},
            {score * drawn / guided, (cost + guide_cost) * guided / drawn});
    }
    /// What a path that was drawn adds to second moment and cost of either way of drawing it.
    struct Work {
        double score = 0, cost = 0;

        void add(const Work& other) {
            score += other.score;
            cost += other.cost;
        }
        void scale(double share) {
            score *= share;
            cost *= share;
        }
        double product() const { return score * cost; }
        void state(StateArchive& archive) {
            archive.amount(score);
            archive.amount(cost);
        }
    };
    void add(const Work& plain, const Work& guided) {
        plain_.add(plain);
        guided_.add(guided);
    }
    /// Keeps this share of what was counted.
    void forget(double share) {
        plain_.scale(share);
        guided_.scale(share);
    }
    /// After `paths` further scored paths. Ways of drawing that are gone say little of the present
    /// one: `memory_paths`, and half of all paths, are the most that count in full.
    void fade(double paths, double memory_paths) {
        paths_ += paths;
        const double memory = std::min(memory_paths, 0.5 * paths_);
        if (memory > 0) forget(memory / (memory + paths));
    }
    /// Saves or restores what was counted.
    void state(StateArchive& archive) {
        plain_.state(archive);
        guided_.state(archive);
        archive.amount(paths_);
    }
    /// Scored paths so far, whether they were worth anything or not.
    double paths() const { return paths_; }
    /// Plain second moment times cost over the guided; 1 before anything was worth something.
    double gain() const {
        const double guided = guided_.product();
        return guided > 0 ? plain_.product() / guided : 1;
    }
    /// The switch after what it was before.
    bool pays(bool on) const { return gain() > (on ? kStayGain : kGain); }

  private:
    Work plain_, guided_;
    double paths_ = 0;
};

}  // namespace aips
