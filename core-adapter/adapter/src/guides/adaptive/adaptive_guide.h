// guide=adaptive: photons are sent where they contribute most to the image, per cost.
//
// Beyond the paper of 2014: the score of a photon is its squared relative contribution to the
// image, every vertex of a path and its start are credited with all that came after, and the
// start is guided too. docs/understand/guides.md.
#pragma once

#include <optional>

#include "aips/adapter/settings.h"
#include "aips/core/base/learned_parts.h"
#include "aips/core/trees/score_cache.h"
#include "contribution/iteration_scores.h"
#include "contribution/path_contribution.h"
#include "contribution/path_log.h"
#include "guides/adaptive/bounce_guide.h"
#include "guides/adaptive/constants.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/part_switch.h"
#include "guides/adaptive/path_means.h"
#include "guides/adaptive/score_survival.h"
#include "guides/adaptive/seed_search.h"
#include "guides/adaptive/survival_switch.h"

namespace aips {

class AdaptiveGuide {
  public:
    /// `light_choice` (by power, not empty) and `importance` outlive this.
    AdaptiveGuide(const Scene& scene, const Settings& settings,
                  const DiscreteDistribution& light_choice, const PixelImportance& importance);
    AdaptiveGuide(const AdaptiveGuide&) = delete;
    AdaptiveGuide& operator=(const AdaptiveGuide&) = delete;

    /// Before the first pass: starts of visible paths that were found, those of one light in
    /// succession. If there are any, none are looked for from the eye.
    void begin_with(std::span<const EmissionSeed> starts);
    /// A pass with these visible points (and their positions) begins; `image` and `radii` stay
    /// until it ends. Returns the rays that seeding traced.
    std::uint64_t begin_pass(std::uint64_t pass, float time, const EyeImage& image,
                             std::span<const Vec3> positions, const GatherRadii& radii);
    /// Of how many paths one is logged, in the next iteration.
    std::uint32_t log_one_of() const;
    /// Photon paths of the next iteration, where an unguided one has so many: few as long as much
    /// is learned, or photons count for less by their number (learning_weight.h).
    std::uint32_t iteration_paths(std::uint32_t unguided) const {
        return learns_at_once() || enabled() ? kIterationPaths : unguided;
    }
    /// Whether iterations are learned from before the next is traced: while what is known grows
    /// fast, photons that follow older knowledge make fireflies.
    bool learns_at_once() const { return paths_ < kEagerPaths; }
    const EmissionGuide* emission() const {
        return emission_part_.enabled() && settings_.guide_emission ? &emission_ : nullptr;
    }
    /// Null unless it is learned what photons may still bring; then vertices are logged too.
    const ScoreSurvival* survival() const {
        return survival_part_.enabled() && survival_ ? &*survival_ : nullptr;
    }
    /// How far that decides which photons go on.
    ScoreMix score_mix() const { return survival() ? survival_switch_.mix() : ScoreMix::None; }
    /// Null unless directions are guided; then vertices are logged too.
    const BounceGuide* bounces() const {
        return bounces_part_.enabled() && bounces_ ? &*bounces_ : nullptr;
    }
    /// Learns from the logged ones of an iteration's paths: changes nothing that photons follow, so
    /// that the next iteration may be traced at the same time.
    void study(const PathLog& log);
    /// After `paths` further photon paths, between iterations: what was studied decides from here
    /// on. Returns how many paths, vertices and photons that was.
    std::uint64_t update(std::uint32_t paths);

    /// Between passes: saves what was learned, or restores it into a new guide; what a pass begins
    /// with is made anew by begin_pass().
    void state(StateArchive& archive);

    /// Saves what was learned for another render, or takes it into a new guide before the first
    /// pass: it fades, and whether parts of the guide pay is judged anew.
    void learned(LearnedParts& parts);

    const EmissionGuide& emission_guide() const { return emission_; }
    /// Whether survival by score was tried and does not pay.
    bool survival_switched_off() const {
        return survival_ && survival_switch_.mix() == ScoreMix::None;
    }
    /// Whether walks from the eye found no way to start a photon, and are no longer done.
    bool seeding_given_up() const { return seeds_.given_up(); }
    /// Whether parts of it were tried and none pays: nothing is learned.
    bool disabled() const { return !enabled(); }
    double survival_gain() const { return survival_switch_.gain(); }
    /// Mean score of a photon path times its mean cost in rays: the relative error of equal-time
    /// images, about. Of the last paths; 0 before anything was scored.
    double score_times_cost() const { return mean_weight_ * path_means_.score_times_cost(); }
    std::size_t node_count() const { return emission_.leaf_count(); }
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(const Scene& scene, const Settings& settings,
                                          std::size_t eye_paths);

  private:
    void update_switches();
    /// Whether anything is learned in this pass: by a part, or for the statistics alone.
    bool enabled() const {
        const bool measures = !settings_.guide_emission && !survival_ && !bounces_;
        return measures || emission() || survival() || bounces();
    }
    /// Calls visit(vertex, contribution) for each that a photon of some power went on from, path by
    /// path, in each from its end to its start.
    template <class Visit>
    void for_each_vertex(const PathLog& log, const Visit& visit) const;
    // From the paths in contributions_.
    void learn_emission(const PathLog& log);
    void learn_survival(const PathLog& log);
    void learn_bounces(const PathLog& log);
    void judge_survival(const PathLog& log);
    SurvivalSwitch::Path judged_path(const PathLog& log, const PathRecord& path) const;

    const Scene& scene_;
    const Settings& settings_;
    const DiscreteDistribution& light_choice_;
    IterationScores scores_;
    EmissionGuide emission_;
    std::optional<ScoreCache> cache_;        // if photons go on by score
    std::optional<ScoreSurvival> survival_;  // reads cache_
    SurvivalSwitch survival_switch_;
    std::optional<BounceGuide> bounces_;  // if directions are guided
    PathMeans path_means_;
    double mean_weight_ = 1;  // of the last pass that was learned from
    SeedSearch seeds_;
    PathContributions contributions_;  // of the iteration studied last
    std::uint64_t paths_ = 0;          // shot so far
    PathLogSize studied_;              // since the last update
    PartSwitch emission_part_, survival_part_, bounces_part_;
    std::uint64_t visible_paths_ = 0;  // logged ones that were worth something
};

}  // namespace aips
