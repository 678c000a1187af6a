// How much sooner a method is as good as the baseline.
#include "equal_error_speedup.h"

#include <algorithm>
#include <cmath>

#include "error_ratio.h"

namespace bench {
namespace {

/// When the curve first is at or below `error`; nothing if never.
std::optional<double> time_of_error(std::span<const CurvePoint> curve, double error) {
    const auto after = std::find_if(curve.begin(), curve.end(),
                                    [&](const CurvePoint& point) { return point.error <= error; });
    if (after == curve.end()) return std::nullopt;
    if (after == curve.begin() || after->error <= 0) return after->seconds;
    const CurvePoint before = *(after - 1);
    const double share = std::log(error / before.error) / std::log(after->error / before.error);
    return before.seconds * std::pow(after->seconds / before.seconds, share);
}

}  // namespace

std::optional<Speedup> equal_error_speedup(std::span<const CurvePoint> method,
                                           std::span<const CurvePoint> baseline, double seconds) {
    const auto error = error_at(baseline, seconds);
    if (error.value_or(0) <= 0 || method.empty()) return std::nullopt;
    // At `seconds` at the latest; rounding of the interpolation must not make it "never".
    const double baseline_s = time_of_error(baseline, *error).value_or(seconds);
    const auto method_s = time_of_error(method, *error);
    if (!method_s) return Speedup{baseline_s / method.back().seconds, Bound::AtMost};
    const bool before_all = method.front().error < *error;
    return Speedup{baseline_s / *method_s, before_all ? Bound::AtLeast : Bound::None};
}

std::optional<MeanSpeedup> mean_speedup(const std::vector<Speedup>& seeds) {
    MeanSpeedup mean;
    std::vector<std::optional<double>> factors;
    for (const auto& [factor, bound] : seeds) {
        if (bound != Bound::None && mean.bound != Bound::None && bound != mean.bound)
            return std::nullopt;
        if (bound != Bound::None) mean.bound = bound;
        factors.emplace_back(factor);
    }
    if (factors.empty()) return std::nullopt;
    const std::vector<std::optional<double>> ones(factors.size(), 1.0);
    const ErrorRatio ratio = error_ratio(factors, ones);
    mean.factor = ratio.ratio.value();
    mean.seeds = ratio.used;
    if (mean.bound != Bound::AtMost) mean.low = ratio.low;
    if (mean.bound != Bound::AtLeast) mean.high = ratio.high;
    return mean;
}

}  // namespace bench
