// The choice of lights of a render that learns between passes: tables of lights, what has not been
// learned yet, and when tables are made anew. For whoever traces shadow rays pass by pass.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/constants.h"
#include "aips/core/base/learned_parts.h"
#include "aips/core/tables/constants.h"
#include "aips/core/tables/light_tables.h"

namespace aips {

/// Of so many of a pass's `paths` one tells what its shadow rays found, `rays` of them at most,
/// while lights are learned from: so that a pass has one in kEarlyOneOf of paths times rays,
/// or about kMostNewRays.
constexpr std::uint32_t paths_per_light_sample(std::uint32_t paths, std::uint32_t rays = 1) {
    return rays * std::max(kEarlyOneOf, std::uint32_t(paths / kMostNewRays));
}

/// How many shadow rays of a pass are to tell, at most.
constexpr std::uint32_t light_samples_due(std::uint32_t paths, std::uint32_t rays = 1) {
    return rays * (paths / paths_per_light_sample(paths, rays) + 1);
}

/// Shadow rays that are to tell before the first pass: as many as it has paths, but enough for
/// choices to be made anew, and no more than are learned from at once.
constexpr std::uint32_t light_samples_ahead(std::uint32_t paths) {
    return std::uint32_t(std::clamp<std::uint64_t>(paths, kFewestNewRays, kMostNewRays));
}

/// at() changes in learn() alone and may be called from many threads in between. Deterministic: a
/// function of the sequence of calls.
class LearnedLights {
  public:
    /// `plain`: the choice without tables, as that of LightTables.
    LearnedLights(const Bounds& scene, const DiscreteDistribution& plain);

    /// The choice among the lights at a place.
    const DiscreteDistribution& at(Vec3 position, Vec3 normal) const {
        return tables_.at(position, normal);
    }

    /// Whether anything was learned.
    bool knows() const { return learned_ > 0; }
    /// Whether there is more to learn.
    bool learns() const { return learned_ < kEnoughRays; }
    /// After `passes` passes: what shadow rays told, in an order that does not depend on threads.
    /// `due`: those that were to tell, found by the numbers of their paths; at least as many as
    /// did. Choices are made anew after a number of those: the number that did depends on the
    /// random numbers that they drew.
    void learn(std::span<const LightSample> samples, std::uint64_t due, std::uint64_t passes);
    /// Passes before the present choices were made. Numbers that are stratified over passes start
    /// anew there: points that keep away from those that were learned from are not independent of
    /// the choices.
    std::uint64_t passes_before() const { return passes_before_; }

    /// Saves what was learned, or restores it into new ones with the same scene and lights.
    void state(StateArchive& archive);
    /// Saves what was learned for another render, or takes it into new ones before the first pass,
    /// if it is of as many lights. It fades, and more is learned.
    void learned(LearnedParts& parts);

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() without what waits to be learned: LightSamples of at most
    /// kMostNewRays and a pass's due rays.
    static std::size_t memory_bound_bytes(std::size_t lights);

  private:
    std::uint64_t due_at_most() const;
    void begin_anew();

    std::size_t lights_;
    LightTables tables_;
    std::vector<LightSample> waiting_;  ///< not learned yet: tables are made anew now and then
    std::uint64_t due_ = 0;             ///< since choices were made
    std::uint64_t learned_ = 0;         ///< that were due before
    std::uint64_t passes_before_ = 0;
};

}  // namespace aips
