// The bias that a radius brings, measured at two radii, and a sample of images without it.
#pragma once

#include "block_test.h"

namespace bench {

/// What a claim multiplies the change of the image between two radii by.
struct BiasFactors {
    double quadratic = 0;  ///< bias goes with radius^2: smooth surfaces
    double linear = 0;     ///< bias goes with radius: edges, where disks hang over
};

/// (r^p - q^p) / (r^p - s^p) for p = 2 and 1: bias at `radius` r less that of references with radii
/// q, over what is seen between r and a smaller radius 0 < s < r. `reference` has mean powers of q:
/// of q^2 and of q; 0 without radius. All in the same unit.
BiasFactors bias_factors(double radius, double smaller, const BiasFactors& reference);

/// Block means of one method, whose radius is biased as the method's under test is, at the radius
/// under test and at a smaller one; the seeds are those of the sample under test, in that order.
struct BiasClaim {
    statistics::BlockMeans at_radius, at_smaller;
    BiasFactors factors;
};

/// `sample` less the bias claimed, seed by seed, so that the claim's own noise stays in the spread.
/// A block's factor is the one between both of `claim` that brings its mean nearest to
/// `references`, the means of their blocks: a block agrees if any bias within the claim explains
/// it.
statistics::BlockMeans without_bias(const statistics::BlockMeans& sample, const BiasClaim& claim,
                                    const std::vector<double>& references);

}  // namespace bench
