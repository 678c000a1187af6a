// Which passes make a batch, and how much each batch tells of the variance of a weighted mean.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lxs/sdk/state_archive.h"

namespace lxs {

/// A pass's weights in the two means that an image is the sum of.
using PairOfWeights = std::array<double, 2>;
/// A figure of each pair of the two parts: first with first, first with second, second with second.
using PerPair = std::array<double, 3>;

/// Batches of consecutive passes whose length grows with the render, so that their number stays
/// small and they are long enough for what stratified passes owe to each other: sampled in an order
/// that avoids the points before, single passes vary more than their mean does.
///
/// When batch b ends, a pixel's mean over passes has moved from M to M', by W' (M' - M) = w (x - M)
/// with x the batch's own mean, w its weight and W' the sum of all weights. If passes are
/// independent with one variance v, the square of that has the expectation
///
///     w^2 v (s / w^2 + S / W^2),   s and S: sums of squared pass weights, of the batch and before,
///
/// of which `trust` = (s / w^2) / (s / w^2 + S / W^2) leaves s v. The sum over batches, times the
/// share of passes that it misses (`completion`), over W^2, is the variance of the mean, also if v
/// changes from batch to batch, and whatever the weights are. Likewise for the products of both
/// parts of an image.
class PassBatches {
  public:
    void end_pass(const PairOfWeights& weights);
    /// Whether the passes since the last batch make one.
    bool full() const;
    /// Passes since the last batch.
    std::uint64_t open_passes() const { return open_.passes; }
    std::uint64_t passes() const { return closed_.passes + open_.passes; }

    /// Of what moved the means since the last batch; 0 where there was no mean before.
    PerPair trust() const;
    /// What sums over batches are to be multiplied by, the open one among them if it has passes;
    /// 0 where no batch has told anything.
    PerPair completion() const;
    /// About as many independent squares as a variance rests on; 0 for none.
    double degrees_of_freedom() const;
    void close();

    /// Throws StateError if what is restored is no such state.
    void state(StateArchive& archive);

  private:
    struct Weights {
        std::uint64_t passes = 0;
        PairOfWeights sum{};
        PerPair products{};  ///< over passes, of weights
        void state(StateArchive& archive);
    };
    PerPair told_by_open() const;

    Weights closed_, open_;
    PerPair told_{};           ///< products of the passes in batches that had a mean before them
    double told_passes_ = 0;   ///< number of those passes
    double squares_told_ = 0;  ///< sum of the squared lengths of those batches
};

}  // namespace lxs
