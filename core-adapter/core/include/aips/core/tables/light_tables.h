// Which of many lights a shadow ray ought to ask: learned from those that lit a place before.
//
// A ScoreCache divides the scene; each leaf has a distribution over the lights. With f the light
// that comes from light l through a shadow ray, variance is least if l is chosen in proportion to
// the root of the mean of f^2 over the leaf (Vevoda, Kondapaneni & Krivanek 2018 learn the same
// with a prior from distances and powers). A share of the choices stays plain, so that no light
// weighs more than 1 / share of what it does without tables, whatever was learned.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/constants.h"
#include "aips/core/tables/constants.h"
#include "aips/core/tables/discrete_distribution.h"
#include "aips/core/trees/score_cache.h"

namespace aips {

struct LightTableSettings {
    ScoreCacheSettings places{.max_leaves = kTableLeaves,
                              .memory_paths = 1e15};  // nothing that is learned grows old
    double plain_share = kPlainShare;                 ///< of choices made without tables, in (0, 1]
    /// Shadow rays that the lights' shares over all leaves weigh in each, > 0.
    double prior_count = kPlacePrior;
};

/// Settings for a number of lights: their tables take 4 MiB at most, up to 40,000 lights.
LightTableSettings light_table_settings(std::size_t lights);

/// What a shadow ray told.
struct LightSample {
    Vec3 position;            ///< of the surface that it started from
    Vec3 normal;              ///< there, any length but 0
    std::uint32_t light = 0;  ///< that was asked
    float pdf = 0;            ///< probability with which it was chosen, > 0
    float value = 0;  ///< luminance that came, without division by pdf, >= 0: 0 in its shadow
};

/// Learns between passes by add() and update(). at() changes at update() alone and may be called
/// from many threads in between. Deterministic: a function of the sequence of calls.
class LightTables {
  public:
    /// `plain`: the choice without tables, not empty; lights that it never chooses are never
    /// chosen. Throws std::invalid_argument when a setting is out of range.
    LightTables(const Bounds& scene, const DiscreteDistribution& plain,
                const LightTableSettings& settings);

    /// The choice among the lights at a place.
    const DiscreteDistribution& at(Vec3 position, Vec3 normal) const {
        return choices_[places_.leaf_at(position, normal)];
    }

    /// Learns from a shadow ray; false, learning nothing, if a number is not usable.
    bool add(const LightSample& sample);
    /// After `samples` calls of add(): splits leaves and makes the choices anew.
    void update(std::size_t samples);

    /// What was learned counts for no more than so many shadow rays.
    void fade(double rays);

    /// Saves what was learned, or restores it into new tables with the same scene and settings. To
    /// be called after update(), with nothing added since.
    void state(StateArchive& archive);

    std::uint32_t leaf_count() const { return places_.leaf_count(); }
    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes(), from the settings and the number of lights alone.
    static std::size_t memory_bound_bytes(const LightTableSettings& settings, std::size_t lights);

  private:
    /// Sums over the shadow rays of a leaf, or of all.
    struct Sums {
        double rays = 0;
        std::vector<double> squares;  // [light]: of value^2 / pdf
    };

    void add_leaves();
    void make_choices();

    LightTableSettings settings_;
    ScoreCache places_;
    std::vector<float> plain_;  // [light]: probability
    Sums everywhere_;
    std::vector<Sums> leaves_;                   // [leaf]
    std::vector<DiscreteDistribution> choices_;  // [leaf]
};

}  // namespace aips
