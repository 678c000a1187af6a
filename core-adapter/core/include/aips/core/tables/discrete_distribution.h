// Choice among finitely many alternatives by weight.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace aips {

/// What a draw gives.
struct DiscreteSample {
    std::size_t index = 0;
    float pdf = 0;  ///< probability of `index`, > 0
    float u = 0;    ///< the random number stretched back to [0, 1), to be used again
};

/// Probabilities proportional to non-negative weights. Weights that are negative or NaN count as
/// zero, infinite ones as the largest float. Alternatives of zero weight are never drawn. Others
/// have a probability of at least 2^-24 and all are multiples of that, so that a random number of
/// 24 bits meets each exactly: pdf() is the true probability, not an approximation.
class DiscreteDistribution {
  public:
    DiscreteDistribution() = default;
    explicit DiscreteDistribution(std::span<const float> weights) { build(weights); }

    /// Replaces the distribution. Throws std::length_error for more than 2^22 weights.
    void build(std::span<const float> weights);

    std::size_t size() const { return cdf_.size(); }
    /// True when nothing can be drawn: no weights, or all of them zero.
    bool empty() const { return total_ <= 0; }
    /// Sum of the weights.
    double total() const { return total_; }
    /// Probability of alternative `index` (< size()); 0 when empty().
    float pdf(std::size_t index) const { return cdf_[index] - before(index); }
    /// Probability of all alternatives before `index` (< size()): the numbers from it on, as many
    /// as pdf(index) says, draw that one.
    float before(std::size_t index) const { return index == 0 ? 0.0f : cdf_[index - 1]; }
    /// Draws by u in [0, 1); must not be empty(). O(log size()).
    DiscreteSample sample(float u) const;

  private:
    std::vector<float> cdf_;  // [index]: probability of all up to and including it
    double total_ = 0;
};

}  // namespace aips
