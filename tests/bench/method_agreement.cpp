// Does a method's expected image agree with the references, and with the baseline at the same
// radius, within noise and the bias it claims?
#include "method_agreement.h"

#include <numeric>

#include "error_ratio.h"
#include "reference_checks.h"

namespace bench {
namespace {

using statistics::BlockMeans;
constexpr std::size_t kFewestSeeds = 3;
/// Of a block, relative to the image's mean: below it less noise is no more weight.
constexpr double kLeastDeviation = 1e-4;

/// Drops the seeds that the claim was not measured with.
SeedBlocks seeds_in_common(const SeedBlocks& method, const RadiusBias& claim) {
    SeedBlocks common;
    for (const auto& [seed, blocks] : method) {
        if (claim.at_radius.contains(seed) && claim.at_smaller.contains(seed))
            common[seed] = blocks;
    }
    return common;
}

BlockMeans means_of_seeds(const SeedBlocks& runs, const SeedBlocks& seeds) {
    BlockMeans means;
    for (const auto& [seed, ignored] : seeds)
        means.push_back(runs.at(seed));
    return means;
}

std::vector<double> block_means(const BlockSample& sample) {
    std::vector<double> means(sample.means.front().size());
    double sum = 0;
    for (std::size_t i = 0; i < sample.means.size(); ++i) {
        const double weight = sample.weights.empty() ? 1 : sample.weights[i];
        sum += weight;
        for (std::size_t k = 0; k < means.size(); ++k)
            means[k] += weight * sample.means[i][k];
    }
    for (double& mean : means)
        mean /= sum;
    return means;
}

double mean_of_all(const BlockMeans& sample) {
    double sum = 0;
    for (const auto& blocks : sample)
        sum += std::accumulate(blocks.begin(), blocks.end(), 0.0) / double(blocks.size());
    return sum / double(sample.size());
}

/// Blocks times `weights`: their own tests stay as they are, their mean becomes a weighted one.
BlockMeans weighted(BlockMeans sample, const std::vector<double>& weights) {
    for (auto& blocks : sample) {
        for (std::size_t k = 0; k < blocks.size(); ++k)
            blocks[k] *= weights[k];
    }
    return sample;
}

Agreement compare(const BlockSample& references, const BlockMeans& method,
                  const BlockMeans& unbiased, const std::vector<double>& weights) {
    Agreement found;
    found.seeds = method.size();
    found.mean_ratio = mean_of_all(method) / mean_of_all({block_means(references)});
    found.comparison =
        statistics::compare(weighted(references.means, weights), weighted(unbiased, weights),
                            kDisagreement, 0, references.weights);
    return found;
}

}  // namespace

BlockMeans all_means(const SeedBlocks& runs) {
    BlockMeans means;
    for (const auto& [seed, blocks] : runs)
        means.push_back(blocks);
    return means;
}

std::vector<double> block_weights(const std::vector<BlockMeans>& samples) {
    constexpr std::size_t kBlocks = std::size_t{kBlocksPerSide} * kBlocksPerSide;
    if (samples.empty()) return std::vector<double>(kBlocks, 1.0);
    std::vector<double> weights;
    for (std::size_t k = 0; k < samples.front().front().size(); ++k) {
        double mean = 0, variance = 0, mean_of_image = 0;
        for (const BlockMeans& sample : samples) {
            mean += mean_of_all(statistics::select(sample, {k}));
            variance += statistics::mean_variance(statistics::select(sample, {k}));
            mean_of_image += mean_of_all(sample);
        }
        const double least = kLeastDeviation * mean_of_image;
        weights.push_back(mean / (variance + least * least));
    }
    return weights;
}

bool Agreement::agrees() const {
    return !comparison.differs() && comparison.detectable <= kDecisive;
}

RatioInterval Agreement::ratio_interval() const {
    const double ratio = comparison.mean_ratio, degrees = comparison.degrees_of_freedom;
    if (!(degrees > 0)) return {ratio, ratio};
    const double half =
        statistics::student_interval(kConfidence, degrees) * comparison.standard_error;
    return {ratio - half, ratio + half};
}

std::optional<Agreement> agreement_with_references(const BlockSample& references,
                                                   const SeedBlocks& method,
                                                   const RadiusBias* claim,
                                                   const std::vector<double>& weights) {
    const SeedBlocks used = claim != nullptr ? seeds_in_common(method, *claim) : method;
    if (used.size() < kFewestSeeds || references.means.size() < kFewestSeeds) return std::nullopt;
    const BlockMeans means = all_means(used);
    if (claim == nullptr) return compare(references, means, means, weights);
    const BiasClaim bias{means_of_seeds(claim->at_radius, used),
                         means_of_seeds(claim->at_smaller, used), claim->factors};
    const BlockMeans unbiased = without_bias(means, bias, block_means(references));
    Agreement found = compare(references, means, unbiased, weights);
    found.bias = found.mean_ratio * (1 - mean_of_all(unbiased) / mean_of_all(means));
    return found;
}

std::optional<Agreement> agreement_with_baseline(const SeedBlocks& baseline,
                                                 const SeedBlocks& method,
                                                 const std::vector<double>& weights) {
    if (baseline.size() < kFewestSeeds || method.size() < kFewestSeeds) return std::nullopt;
    const BlockMeans means = all_means(method);
    return compare({all_means(baseline), {}}, means, means, weights);
}

}  // namespace bench
