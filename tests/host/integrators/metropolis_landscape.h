// A function known on paper, for chains of Metropolis sampling to estimate.
#pragma once

#include <cstdint>
#include <vector>

#include "path/metropolis_chain.h"

namespace lxs::test {

constexpr std::uint32_t kLandscapeSize = 8;  ///< of the film, pixels

/// Brightness by pixel, from 0 to a peak of a hundred times the mean.
double landscape_height(std::uint32_t x, std::uint32_t y);

/// Of all pixels.
double landscape_mean();

/// In the left half of the film brightness depends on five more coordinates, so that moves change
/// the number of those in use; its mean over them is landscape_height.
class Landscape : public MetropolisTarget {
  public:
    void evaluate(PrimarySample& sample, Contribution& contribution) override;
};

/// Starts a chain at a point drawn in proportion to brightness, by rejection.
void start_fairly(MetropolisChain& chain, std::uint64_t seed);

struct ChainRun {
    MetropolisSettings settings;
    double guess = landscape_mean();
    std::uint64_t mutations = 3000;
};

/// Mean per pixel of the splats of one chain: an unbiased estimate of the landscape.
std::vector<double> image_of(const ChainRun& run, std::uint64_t seed,
                             ChainCounts* counts = nullptr);

}  // namespace lxs::test
