// Choices that random numbers of 24 bits, and finer ones, meet exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace lxs {

/// Fills cdf[i + 1] with the probability of the weights up to i, as a multiple of 2^-24; cdf[0] is
/// 0. Zero weights get nothing, others at least 2^-24: differences are the probabilities with which
/// uniform numbers find_step() them, exactly, and not those of the weights. `weights` must be
/// finite, >= 0, and at most 2^23; `cdf` is longer by one. Of n weights none keeps less than
/// 1 - n 2^-24 of its probability. If all are zero, so is `cdf`. Returns their sum.
template <class T>
double quantize_cdf(std::span<const T> weights, std::span<float> cdf) {
    constexpr double kSteps = 0x1p24;
    double total = 0, positive = 0;
    for (const T w : weights) {
        total += double(w);
        positive += w > 0 ? 1 : 0;
    }
    // One step is set aside for each positive weight, and the others are shared in proportion.
    double sum = 0, set_aside = 0;
    cdf[0] = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += double(weights[i]);
        set_aside += weights[i] > 0 ? 1 : 0;
        if (!(weights[i] > 0)) {
            cdf[i + 1] = cdf[i];
            continue;
        }
        const double share = set_aside == positive ? 1.0 : std::min(1.0, sum / total);
        cdf[i + 1] = float((set_aside + std::floor(share * (kSteps - positive))) / kSteps);
    }
    return total;
}

/// The step of a CDF as above, not all zero, that `u` in [0, 1) falls into.
inline std::size_t find_step(std::span<const float> cdf, double u) {
    const auto above = std::upper_bound(cdf.begin() + 1, cdf.end() - 1, u);
    return static_cast<std::size_t>(above - cdf.begin()) - 1;
}

}  // namespace lxs
