// The primary coordinates of one Markov chain: those of its path, and those of the next proposed.
#pragma once

#include <cstddef>
#include <vector>

#include "path/random_stream.h"

namespace lxs {

/// Lengths of small mutations in fractions of the unit interval, 0 < smallest <= largest:
/// exponentially distributed, d = largest * exp(-log(largest / smallest) u). Defaults: Kelemen et
/// al. 2002, section 4.
struct MutationRange {
    double smallest = 1.0 / 1024;
    double largest = 1.0 / 64;
};

/// `value` in [0,1) moved by a random length in a random direction, around the ends of the unit
/// interval; as likely as the move back. `u` in [0,1).
float mutate(float value, float u, const MutationRange& range);

/// A chain's point in primary sample space. Coordinates come to be when a path asks for them. Those
/// that the present path does not read have no bearing on it: given the others they are uniform,
/// and a longer path draws them anew. A move and the move back are thus equally likely, whatever
/// the lengths of the two paths, and nothing has to be kept that no path reads.
class MetropolisCoordinates final : public PrimarySample {
  public:
    /// The first two dimensions, the place on the film, have mutation ranges of their own.
    MetropolisCoordinates(const MutationRange& film_x, const MutationRange& film_y)
        : film_x_(film_x), film_y_(film_y) {}

    /// What is read from now on is a proposal made of `random`: drawn anew if `large`, else the
    /// present coordinates mutated.
    void propose(const RandomStream& random, bool large);
    /// The proposal becomes the present. Without it, the next proposal replaces the last.
    void accept() { present_.swap(proposed_); }

    /// Of the present coordinates, between a step and the next proposal.
    void state(StateArchive& archive);

    /// Longest path prefix that is mutated: a bound for memory. Later coordinates are always drawn
    /// anew, a symmetric proposal as well.
    static constexpr std::size_t kMostStored = 1024;

  private:
    void next_block(Block& block) override;
    const MutationRange& range(std::size_t dimension) const;

    MutationRange film_x_, film_y_, other_;
    std::vector<float> present_, proposed_;
    RandomStream random_{0, 0, 0};
    bool large_ = true;
};

}  // namespace lxs
