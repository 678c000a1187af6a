// Cumulative distributions that random numbers of 24 bits meet exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "aips/core/sampling/sampling.h"

namespace aips {

/// Most weights that a quantized distribution may have.
inline constexpr std::size_t kMaxQuantizedWeights = std::size_t(1) << 22;

/// Fills cdf[i] with the probability of all weights up to i, as a multiple of 2^-24; from the last
/// positive weight on it is 1. Zero weights get nothing, others at least 2^-24. `weights` must be
/// sanitized (finite, >= 0), of sum `total` > 0, and at most kMaxQuantizedWeights; `cdf` is as
/// long. Of n weights none keeps less than 1 - n 2^-24 of its probability: one step is its own, and
/// what rounding down takes from its part of the others is less than a step.
template <class T>
void quantize_cdf(std::span<const T> weights, double total, std::span<float> cdf) {
    constexpr double kSteps = 0x1p24;
    const auto positive =
        double(std::count_if(weights.begin(), weights.end(), [](T w) { return w > 0; }));
    // One step is set aside for each positive weight, and the others are shared in proportion.
    const double shared = kSteps - positive;
    double sum = 0;
    double set_aside = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += double(weights[i]);
        set_aside += weights[i] > 0 ? 1 : 0;
        const double share = set_aside == positive ? 1.0 : std::min(1.0, sum / total);
        cdf[i] = float((set_aside + std::floor(share * shared)) / kSteps);
    }
}

/// Where u in [lower, upper) falls within that interval, stretched to [0, 1).
inline float stretch(float u, float lower, float upper) {
    return clamp_to_unit((u - lower) / (upper - lower));
}

}  // namespace aips
