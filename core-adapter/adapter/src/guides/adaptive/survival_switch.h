// How far scores decide which photons go on: second moment times cost of photon paths, for each way
// to decide.
//
// All ways are estimated from the paths that were traced, whichever decided there. Where s photons
// went on and another way asks for s', photons carry k = s / s' times the power, and come 1 / k
// times as often: their squared contributions count k times, the rays after the vertex 1 / k times.
// Where s is above 1, photons were split, and the one that was logged stands for s of them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "aips/core/tables/constants.h"
#include "contribution/path_log.h"
#include "guides/adaptive/constants.h"
#include "guides/adaptive/second_moments.h"

namespace aips {

class SurvivalSwitch {
  public:
    /// Walks along one path: part by part, with the vertex where it went on between two parts.
    class Path {
      public:
        /// Score and cost, in rays, of what came since the last vertex.
        void add(double score, double cost) {
            for (Way& way : ways_) {
                way.work.score += score * way.power * photons_;
                way.work.cost += cost / way.power * photons_;
            }
        }
        void survive(const Survival& s);

      private:
        friend class SurvivalSwitch;
        struct Way {
            SecondMoments::Work work;
            double power = 1;  ///< over that of the photon that was traced
        };
        std::array<Way, 3> ways_;  // [ScoreMix]
        double photons_ = 1;       // that the logged one stands for
    };

    void add(const Path& path);
    /// After `paths` further scored photon paths, of which `memory_paths` count in full.
    void update(double paths, double memory_paths);

    /// What was decided stays until it is judged anew, by what is counted from here on.
    void begin_anew() { half_ = quarters_ = {}; }

    /// Saves or restores what was counted and decided.
    void state(StateArchive& archive) {
        half_.state(archive);
        quarters_.state(archive);
        archive.value(mix_, ScoreMix::Quarters);
    }

    ScoreMix mix() const { return mix_; }
    /// Of the better way by score.
    double gain() const { return std::max(half_.gain(), quarters_.gain()); }

  private:
    SecondMoments half_, quarters_;  // against roulette by power
    ScoreMix mix_ = ScoreMix::Half;
};

inline void SurvivalSwitch::Path::survive(const Survival& s) {
    for (std::size_t mix = 0; mix < ways_.size(); ++mix) {
        Way& way = ways_[mix];
        // Those that do not survive look up scores, too.
        if (mix > 0) way.work.cost += kLookUpCost * photons_ / (way.power * double(s.photons));
        way.power *= double(s.photons) /
                     double(photons_going_on(s, static_cast<ScoreMix>(mix), float(way.power)));
    }
    photons_ *= std::max(1.0, double(s.photons));
}

inline void SurvivalSwitch::add(const Path& path) {
    for (const Path::Way& way : path.ways_) {
        if (!std::isfinite(way.work.score) || !std::isfinite(way.work.cost)) return;
    }
    half_.add(path.ways_[0].work, path.ways_[1].work);
    quarters_.add(path.ways_[0].work, path.ways_[2].work);
}

inline void SurvivalSwitch::update(double paths, double memory_paths) {
    half_.fade(paths, memory_paths);
    quarters_.fade(paths, memory_paths);
    if (half_.paths() < kShortMemoryPaths) return;
    const bool more = quarters_.gain() > half_.gain();
    mix_ = gain() <= 1 ? ScoreMix::None : more ? ScoreMix::Quarters : ScoreMix::Half;
}

}  // namespace aips
