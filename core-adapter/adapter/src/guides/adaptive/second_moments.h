// Whether a guided density pays: second moment times cost, on samples that did not shape it.
//
// A sample drawn with density p that was worth Q = (f / p)^2 tells the second moment that another
// density p' would give, E_p[Q p / p'], and the cost of its paths, E_p[c p' / p]. Judged on the
// samples that had shaped the density themselves, moments come out too low.
//
// Scores have heavy tails: one path in a million, drawn where the guided density is least, may
// outweigh all others. Samples are therefore dealt out to five groups, and the median of what these
// say is taken: no single path decides (median of means: Nemirovsky and Yudin 1983).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "aips/core/base/state_archive.h"
#include "guides/adaptive/constants.h"

namespace aips {

class SecondMoments {
  public:
    static constexpr std::size_t kGroups = kMomentGroups;

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
        Group& group = groups_[next_];
        next_ = (next_ + 1) % kGroups;
        group.plain.add(plain);
        group.guided.add(guided);
    }
    /// Keeps this share of what was counted.
    void forget(double share) {
        for (Group& group : groups_) {
            group.plain.scale(share);
            group.guided.scale(share);
        }
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
        for (Group& group : groups_) {
            group.plain.state(archive);
            group.guided.state(archive);
        }
        archive.value(next_);
        StateArchive::check(next_ < kGroups, "a group of moments that is none");
        archive.amount(paths_);
    }
    /// Scored paths so far, whether they were worth anything or not.
    double paths() const { return paths_; }
    /// Plain second moment times cost over the guided, the median of the groups'; 1 before anything
    /// was worth something.
    double gain() const {
        std::array<double, kGroups> gains;
        for (std::size_t i = 0; i < kGroups; ++i) {
            const double guided = groups_[i].guided.product();
            gains[i] = guided > 0 ? groups_[i].plain.product() / guided : 1;
        }
        std::nth_element(gains.begin(), gains.begin() + kGroups / 2, gains.end());
        return gains[kGroups / 2];
    }

  private:
    struct Group {
        Work plain, guided;
    };
    std::array<Group, kGroups> groups_;
    std::uint32_t next_ = 0;
    double paths_ = 0;
};

}  // namespace aips
