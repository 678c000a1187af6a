// Whether roulette by score pays: second moment times cost of photon paths, against roulette by the
// power left.
//
// Both are estimated from the paths that were traced, whichever decided there. A path that got
// through with other probabilities carries k times the power, k being the product of the quotients
// drawn / other, and is traced 1 / k times as often: its squared contributions count k times, the
// rays after the vertex 1 / k times.
#pragma once

#include <cmath>
#include <cstdint>

#include "path_log.h"
#include "second_moments.h"

namespace aips {

class SurvivalSwitch {
  public:
    /// Walks along one path: part by part, with the vertex where it went on between two parts.
    class Path {
      public:
        /// Score and cost, in rays, of what came since the last vertex.
        void add(double score, double cost) {
            plain_.add(score, cost);
            scored_.add(score, cost);
        }
        void survive(const Survival& s) {
            // Those that do not survive look up scores, too.
            scored_.work.cost += kLookUpCost / (scored_.power * double(s.probability));
            plain_.survive(s.plain, s);
            scored_.survive(s.scored >= 0 ? s.scored : s.plain, s);
        }

      private:
        friend class SurvivalSwitch;
        struct Way {
            SecondMoments::Work work;
            double power = 1;  ///< over that of the photon that was traced

            void add(double score, double cost) {
                work.score += score * power;
                work.cost += cost / power;
            }
            void survive(float probability, const Survival& drawn) {
                power *= double(drawn.probability) /
                         double(limited_survival(probability * float(power)));
            }
        };
        Way plain_, scored_;
    };

    void add(const Path& path) {
        const auto usable = [](const Path::Way& way) {
            return std::isfinite(way.work.score) && std::isfinite(way.work.cost);
        };
        if (usable(path.plain_) && usable(path.scored_)) {
            moments_.add(path.plain_.work, path.scored_.work);
        }
    }
    /// After `paths` further scored photon paths, of which `memory_paths` count in full.
    void update(double paths, double memory_paths);

    bool on() const { return on_; }
    double gain() const { return moments_.gain(); }

  private:
    /// Cost of looking up what a photon may still bring, in rays: measured in cornell-box.
    static constexpr double kLookUpCost = 0.2;
    /// Scored photon paths before it may be switched off.
    static constexpr double kTrialPaths = 1e5;

    SecondMoments moments_;
    bool on_ = true;
};

inline void SurvivalSwitch::update(double paths, double memory_paths) {
    moments_.fade(paths, memory_paths);
    on_ = moments_.paths() < kTrialPaths || moments_.pays(on_);
}

}  // namespace aips
