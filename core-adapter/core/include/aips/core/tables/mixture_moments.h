// Which share of directions to draw from a table: second moment times cost of the one-sample
// mixtures a * table + (1 - a) * plain, on samples that did not shape the table.
//
// A direction drawn with density p that led to a score Q = (f / p)^2 and a cost c tells the second
// moment that another density p' would give, E_p[Q p / p'], and the cost, E_p[c p' / p].
// Sources: Veach & Guibas 1995 (the one-sample model); Vorba et al. 2019 (a learned mixture share
// at each place; here the choice is between few shares, and may be none).
#pragma once

#include <array>
#include <cstddef>

#include "aips/core/base/constants.h"
#include "aips/core/base/state_archive.h"
#include "aips/core/tables/constants.h"
#include "aips/core/trees/constants.h"

namespace aips {

/// Densities of one direction, all in the same measure.
struct DirectionDensities {
    double drawn = 0;  ///< with which it was drawn, > 0
    double plain = 0;  ///< without a table
    double table = 0;  ///< of the table alone
};

/// Sums over one place's samples.
class MixtureMoments {
  public:
    /// A direction led to `score` and cost `cost` rays, both >= 0. One that cannot be drawn without
    /// a table (density 0) carries no light, and is left out, as are scores whose squares a double
    /// cannot hold.
    /// It stands for `weight` like it.
    void add(double score, double cost, const DirectionDensities& densities, double weight = 1);
    void add(const MixtureMoments& other);
    /// Keeps this share of what was counted.
    void scale(double share);

    /// Saves or restores the sums.
    void state(StateArchive& archive);

    /// Sum of second moments with share number `i` in use.
    double moment(std::size_t i) const { return moments_[i]; }
    /// Second moment with share number `i` over that with none; 1 before anything had a score.
    double moment_ratio(std::size_t i) const;
    /// The same of mean costs, `table_cost` rays being what a table costs each time.
    double cost_ratio(std::size_t i, double table_cost) const;
    double count() const { return count_; }
    /// Samples with equal scores that would tell as much (Kish 1965).
    double effective_count() const;

  private:
    std::array<double, kTableShares.size()> moments_{}, costs_{};
    double squares_ = 0;  // of the terms of moments_[0]
    double count_ = 0;
};

struct ShareSettings {
    /// Least gain, second moment times cost without a table over that with one, at which a table
    /// comes into use; in use it stays as long as it gains anything.
    double gain = kLeastGain;
    /// Effective samples that the prior weighs: what all places together say.
    double prior_count = kPlacePrior;
    /// Of drawing from a table and asking for its density, in rays.
    double table_cost = kLookUpCost;
};

/// Number of the share in kTableShares with the least second moment times cost at a place whose
/// samples are `here`, `everywhere` being those of all places and `present` the share in use.
std::size_t choose_share(const MixtureMoments& here, const MixtureMoments& everywhere,
                         std::size_t present, const ShareSettings& settings = {});

}  // namespace aips
