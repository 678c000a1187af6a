// Closed form of Knaus & Zwicker's recursion.
#include "aips/core/radii/radius_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aips {
namespace {

/// ln Gamma(x) less (x - 1/2) ln x - x + ln(2 pi) / 2: Stirling's series, to 1e-14 for x >= 16.
double stirling_tail(double x) {
    const double z = 1 / (x * x);
    return (1.0 / 12 - z * (1.0 / 360 - z * (1.0 / 1260 - z / 1680))) / x;
}

/// ln(Gamma(n + alpha) / Gamma(n + 1)) for n >= 1. The difference of two lgamma would cancel: at
/// n = 1e12 they are 3e13, with an error of 4e-3. So Stirling's formula is subtracted term by term,
/// after 16 steps up, which make its series converge.
double log_gamma_ratio(double n, double alpha) {
    constexpr int kSteps = 16;
    double up = 1;
    for (int k = 0; k < kSteps; ++k)
        up *= (n + k + 1) / (n + k + alpha);
    const double x = n + kSteps + alpha;
    const double y = n + kSteps + 1;
    return std::log(up) + (x - 0.5) * std::log1p((alpha - 1) / y) + (alpha - 1) * std::log(y) +
           (1 - alpha) + stirling_tail(x) - stirling_tail(y);
}

/// Clamps to [low, high], NaN to `otherwise`.
double clamp_or(double x, double low, double high, double otherwise) {
    return std::isnan(x) ? otherwise : std::clamp(x, low, high);
}

}  // namespace

float knaus_zwicker_radius(double initial_radius, double paths_shot, double reference_paths,
                           double alpha, double minimum) {
    constexpr double kSmallest = std::numeric_limits<float>::min();
    constexpr double kGreatest = std::numeric_limits<float>::max();
    const double r0 = clamp_or(initial_radius, kSmallest, kGreatest, kSmallest);
    const double floor = clamp_or(minimum, kSmallest, r0, kSmallest);
    const double shot = clamp_or(paths_shot, 0.0, 1e300, 0.0);
    const double n = 1 + shot / clamp_or(reference_paths, 1.0, 1e300, 1.0);
    const double a = clamp_or(alpha, 0.0, 1.0, 1.0);
    const double log_shrink = log_gamma_ratio(n, a) - log_gamma_ratio(1, a);
    return float(std::max(floor, r0 * std::exp(0.5 * std::min(0.0, log_shrink))));
}

}  // namespace aips
