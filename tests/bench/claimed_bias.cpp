// The bias that a radius brings, measured at two radii, and a sample of images without it.
#include "claimed_bias.h"

#include <algorithm>

namespace bench {
namespace {

using statistics::BlockMeans;

double block_mean(const BlockMeans& sample, std::size_t block) {
    double sum = 0;
    for (const auto& blocks : sample)
        sum += blocks[block];
    return sum / double(sample.size());
}

/// The factor that brings `difference` - factor x `change` nearest to 0.
double best_factor(double difference, double change, const BiasFactors& factors) {
    const auto [least, most] = std::minmax(factors.quadratic, factors.linear);
    return change == 0 ? least : std::clamp(difference / change, least, most);
}

}  // namespace

BiasFactors bias_factors(double radius, double smaller, const BiasFactors& reference) {
    return {(radius * radius - reference.quadratic) / (radius * radius - smaller * smaller),
            (radius - reference.linear) / (radius - smaller)};
}

BlockMeans without_bias(const BlockMeans& sample, const BiasClaim& claim,
                        const std::vector<double>& references) {
    BlockMeans corrected = sample;
    for (std::size_t k = 0; k < references.size(); ++k) {
        const double change = block_mean(claim.at_radius, k) - block_mean(claim.at_smaller, k);
        const double difference = block_mean(sample, k) - references[k];
        const double factor = best_factor(difference, change, claim.factors);
        for (std::size_t i = 0; i < sample.size(); ++i)
            corrected[i][k] -= factor * (claim.at_radius[i][k] - claim.at_smaller[i][k]);
    }
    return corrected;
}

}  // namespace bench
