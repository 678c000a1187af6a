// Choice by a quantized cumulative distribution.
#include "aips/core/tables/discrete_distribution.h"

#include <algorithm>
#include <stdexcept>

#include "aips/core/tables/directional_table.h"
#include "tables/quantized_cdf.h"

namespace aips {

void DiscreteDistribution::build(std::span<const float> weights) {
    if (weights.size() > kMaxQuantizedWeights) {
        throw std::length_error("DiscreteDistribution: more than 2^22 weights");
    }
    total_ = 0;
    std::vector<float> clean(weights.size());
    std::transform(weights.begin(), weights.end(), clean.begin(), sanitized_weight);
    for (const float w : clean)
        total_ += double(w);
    cdf_.assign(weights.size(), 0.0f);
    if (total_ > 0) quantize_cdf(std::span<const float>(clean), total_, cdf_);
}

DiscreteSample DiscreteDistribution::sample(float u) const {
    u = clamp_to_unit(u);
    const auto it = std::upper_bound(cdf_.begin(), cdf_.end(), u);
    const auto index = static_cast<std::size_t>(it - cdf_.begin());
    const float lower = index == 0 ? 0.0f : cdf_[index - 1];
    return {index, cdf_[index] - lower, stretch(u, lower, cdf_[index])};
}

}  // namespace aips
