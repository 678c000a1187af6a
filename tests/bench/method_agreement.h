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

/// What one comparison says. Ratios are of means over all blocks.
struct Agreement {
    std::size_t seeds = 0;              ///< used of the method
    double mean_ratio = 0;              ///< method over what it is compared with
    std::optional<double> bias;         ///< claimed, relative; nothing if none is
    statistics::Comparison comparison;  ///< of what is left without that bias
    /// No difference was found though one of kDecisive would have been.
    bool agrees() const;
};

/// The method against references, of which `claim` tells the bias at its radius; null: none is
/// claimed. Nothing with fewer than three seeds in common.
std::optional<Agreement> agreement_with_references(const BlockSample& references,
                                                   const SeedBlocks& method,
                                                   const RadiusBias* claim);

/// The method against another at the same radius: noise is all that they may differ by. Nothing
/// with fewer than three seeds of either.
std::optional<Agreement> agreement_with_baseline(const SeedBlocks& baseline,
                                                 const SeedBlocks& method);

}  // namespace bench
