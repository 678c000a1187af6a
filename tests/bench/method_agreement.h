// Does a method's expected image agree with the references, and with the baseline at the same
// radius, within noise and the bias it claims?
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "claimed_bias.h"

namespace bench {

/// Largest detectable difference of the mean with which a test may say that images agree.
inline constexpr double kDecisive = 0.05;

/// Independent images of one expectation as means of blocks.
struct BlockSample {
    statistics::BlockMeans means;
    std::vector<double> weights;  ///< variance goes with 1 / weight; none: all are equal
};

/// Block means of a method's runs by seed.
using SeedBlocks = std::map<std::uint64_t, std::vector<double>>;

/// The baseline's images at the radius under test and at a smaller one.
struct RadiusBias {
    SeedBlocks at_radius, at_smaller;
    BiasFactors factors;
};

/// What each block counts for in the mean that a comparison tests: mean / variance over seeds, both
/// averaged over `samples` (at least two seeds each), the best weights to find a common factor by.
/// A lamp seen in a mirror, a few pixels as bright as the rest together, would else hide it. All
/// are 1 without samples.
std::vector<double> block_weights(const std::vector<statistics::BlockMeans>& samples);

/// Ends of the interval of kConfidence around a ratio.
struct RatioInterval {
    double low = 0, high = 0;
};

/// What one comparison says.
struct Agreement {
    std::size_t seeds = 0;       ///< used of the method
    double mean_ratio = 0;       ///< method over what it is compared with, blocks counting alike
    std::optional<double> bias;  ///< claimed of that ratio; nothing if none is
    /// Of what is left without that bias; its mean is that of weighted blocks.
    statistics::Comparison comparison;
    /// No difference was found though one of kDecisive would have been.
    bool agrees() const;
    /// t-interval of the weighted means' ratio; no wider than the ratio where seeds show no spread.
    RatioInterval ratio_interval() const;
};

/// Block means of all runs, in order of seeds.
statistics::BlockMeans all_means(const SeedBlocks& runs);

/// The method against references, of which `claim` tells the bias at its radius; null: none is
/// claimed. `weights` are those of the blocks. Nothing with fewer than three seeds in common.
std::optional<Agreement> agreement_with_references(const BlockSample& references,
                                                   const SeedBlocks& method,
                                                   const RadiusBias* claim,
                                                   const std::vector<double>& weights);

/// The method against another at the same radius: noise is all that they may differ by. Nothing
/// with fewer than three seeds of either.
std::optional<Agreement> agreement_with_baseline(const SeedBlocks& baseline,
                                                 const SeedBlocks& method,
                                                 const std::vector<double>& weights);

}  // namespace bench
