// Optimal radius and probes.
#include "aips/core/radii/optimal_radius.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aips {

double optimal_radius(double second_moment, double squared_laplacian, double paths) {
    return std::pow(32 * second_moment / (3 * std::numbers::pi * paths * squared_laplacian),
                    1.0 / 6);
}

void ProbeSums::add(double value, double share) {
    squares += value * value;
    for (std::size_t scale = 0; scale < kProbeScales && share <= 1; ++scale, share *= 4) {
        const double weighted = value * curvature_weight(share);
        curvature[scale] += weighted;
        uncertainty[scale] += weighted * weighted;
    }
}

void ProbeSums::scale(double factor) {
    squares *= factor * factor;
    for (double& sum : curvature)
        sum *= factor;
    for (double& sum : uncertainty)
        sum *= factor * factor;
}

ProbeEstimate probe_estimate(const ProbeSums& sums, double radius, double paths) {
    double squared_radius = radius * radius;
    const double disc_paths = std::numbers::pi * squared_radius * paths;
    ProbeEstimate estimate;
    estimate.second_moment = sums.squares / disc_paths;
    for (std::size_t scale = 0; scale < kProbeScales; ++scale, squared_radius /= 4) {
        const double unit = 1 / (std::numbers::pi * squared_radius * paths * squared_radius);
        estimate.laplacian[scale] = {sums.curvature[scale] * unit,
                                     sums.uncertainty[scale] * unit * unit};
    }
    return estimate;
}

double expected_squared_laplacian(const ProbeEstimate& estimate) {
    const auto& laplacian = estimate.laplacian;
    double squared = laplacian[0].value * laplacian[0].value + laplacian[0].error2;
    for (std::size_t scale = 1; scale < kProbeScales; ++scale) {
        const double sure = laplacian[scale].value * laplacian[scale].value -
                            kSureOfCurvature * kSureOfCurvature * laplacian[scale].error2;
        squared = std::max(squared, sure);
    }
    return squared;
}

}  // namespace aips
