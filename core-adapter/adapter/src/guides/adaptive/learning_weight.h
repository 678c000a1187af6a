// What photons count for in the image that were shot while a guide still learned.
//
// A density that is wrong where it matters makes few photons carry much: fireflies, which a mean
// over all photons keeps for good. Weights that depend on nothing but the number of photon paths
// shot before leave the expectation as it is, whatever the guide did with these.
//
// Bound on fireflies: weights never fall, so of N photon paths the last count most, w(N) of the sum
// of all weights. That sum is about that of w(N) (n / N)^2, N w(N) / 3, or more while weights are
// at their least, and less as blocks of 16384 paths have the weight of their first: of K blocks by
// 3 / (2 K) of it, K being 16 where they have left the least. No path counts more than 3.2 times
// what it does in a plain mean.
#pragma once

#include <algorithm>
#include <cstdint>

#include "guides/adaptive/constants.h"

namespace aips {

/// Of the very first photons, not zero: an image that is stopped early is made of them.
inline constexpr double kFirstWeight = 1.0 / 64;

/// Weight in (0, 1] of photon paths before which `paths_before` others were shot.
inline double learning_weight(std::uint64_t paths_before) {
    const double learned = double(paths_before) / kLearningPaths;
    return std::clamp(learned * learned, kFirstWeight, 1.0);
}

}  // namespace aips
