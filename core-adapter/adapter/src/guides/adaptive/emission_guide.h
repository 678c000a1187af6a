// Where photons start: a learned density over lights and their primary coordinates.
//
// Per light a PrimaryTree; light choice and coordinates together are one mixture of three
// densities over (light, [0,1)^4): the plain one (by power, uniform), that of the seeds and the
// learned one. The choice between lights falls out of the trees' masses.
#pragma once

#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/base/constants.h"
#include "aips/core/tables/constants.h"
#include "aips/core/tables/discrete_distribution.h"
#include "aips/core/trees/primary_tree.h"
#include "guides/adaptive/constants.h"
#include "guides/adaptive/emission_seed.h"
#include "guides/adaptive/second_moments.h"

namespace aips {

struct EmissionGuideSettings {
    double plain_share = kPlainShare;  ///< defensive: see EmissionGuide
    /// Of densities found from the eye, until enough was learned.
    double seed_share = kSeedStarts;
    double learned_seed_share = kLearnedSeedStarts;  ///< after that
    std::uint32_t learned_scores = kLearnedScores;   ///< scored photons that count as enough
    /// Over all lights that emit, but at least one for each.
    std::uint32_t max_leaves = kMostLearnedLeaves;
    double memory_paths = 4e6;               ///< scored photon paths that count in full
    double trial_paths = kShortMemoryPaths;  ///< scored ones before the guide may be switched off
};

/// Where one photon starts.
struct EmissionStart {
    LightIndex light = 0;
    PrimaryPoint point{};
    double pdf = 1;  ///< over lights and coordinates
};

/// What a photon path contributed.
struct EmissionScore {
    EmissionStart start;
    double score = 0;  ///< square of its part in the image, at the power it carried
    double cost = 0;   ///< in rays
};

/// Starts whose photons the guide has thinned to less than this share count as pruned.
inline constexpr double kPrunedDensity = 0.25;

/// Learns between iterations; const in between, when it may be used from many threads.
///
/// Bound on fireflies: a photon of light l weighs P0(l) / p(l, x) times what it would without the
/// guide, P0 being the choice by power. As p(l, x) >= plain_share P0(l), that is at most
/// 1 / plain_share, whatever was learned. Rounding: of n lights each keeps 1 - n 2^-24 of its
/// probability (quantized_cdf.h), and a tree 1 - 124 * 2^-23 of its densities (PrimaryTree).
class EmissionGuide {
  public:
    /// `plain_choice` chooses between `lights` by power and is not empty; it outlives this.
    EmissionGuide(std::size_t lights, const DiscreteDistribution& plain_choice,
                  const EmissionGuideSettings& settings = {});

    /// Draws a start by u in [0, 1)^4 and u_light; the plain one if the guide is off.
    EmissionStart sample(float u_light, const PrimaryPoint& u) const;

    void add(const EmissionScore& score);
    /// A photon that was not drawn by the guide, and stands for `part` >= 0 of the integral of
    /// abs(f) times the paths of the next update(). It tells nothing of whether guiding pays.
    void add_part(const EmissionStart& start, double part, double cost);
    /// Halves leaves in which many of these starts, those of one light in succession, lie close
    /// together.
    void focus(std::span<const EmissionSeed> starts);
    /// Starts found from the eye, or by chains, those of one light in succession. Of lights that do
    /// not emit, or do not exist, they are passed over.
    void add_seeds(std::span<const EmissionSeed> seeds);
    /// After `paths` further photon paths: forgets, splits, decides whether guiding pays, and sets
    /// the density of the next iterations.
    void update(double paths);

    /// Saves what was learned, or restores it into a new guide for the same lights. To be called
    /// after update(), with nothing added since.
    void state(StateArchive& archive);

    /// What was learned in another render counts for no more than `paths` scored photon paths, and
    /// whether guiding pays is judged anew.
    void begin_anew(double paths);
    /// Stands for all that a guide must have alike to take what this one learned: which lights
    /// there are that emit.
    std::uint64_t fit() const;

    /// Whether sample() follows what was learned.
    bool on() const { return on_; }
    /// Plain second moment times cost over guided, on samples that did not shape the density.
    double gain() const { return moments_.gain(); }
    /// Whether it was tried and does not pay.
    bool switched_off() const { return learned_ && !on_; }
    /// Share of what the plain density emits that starts where photons are now fewer than `density`
    /// times the plain one's; 0 while the guide is off.
    double starved_share(double density) const;
    std::size_t leaf_count() const;
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(const DiscreteDistribution& plain_choice,
                                          const EmissionGuideSettings& settings = {});

  private:
    double plain_pdf(LightIndex light) const { return double(plain_choice_->pdf(light)); }
    double guided_pdf(const EmissionStart& start) const;
    void judge();
    void set_densities();
    template <class Visit>
    void for_each_light(std::span<const EmissionSeed> seeds, const Visit& visit) const;

    const DiscreteDistribution* plain_choice_;
    EmissionGuideSettings settings_;
    std::vector<PrimaryTree> trees_;  // [light]
    std::vector<double> seeds_;       // [light]: weight
    DiscreteDistribution choice_;     // between lights, all three densities together
    SecondMoments moments_;
    std::uint64_t scored_ = 0;
    bool learned_ = false;  // trees and choice hold anything
    bool on_ = false;
};

}  // namespace aips
