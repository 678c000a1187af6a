// The error at a budget, between the snapshots that a run really took.
#include "budget_curve.h"

#include <algorithm>
#include <cmath>

namespace bench {

std::optional<double> error_at(std::span<const CurvePoint> curve, double seconds) {
    const auto after = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& point) {
        return point.seconds >= seconds;
    });
    if (after == curve.end()) return std::nullopt;
    if (after->seconds == seconds) return after->error;
    if (after == curve.begin()) return std::nullopt;
    const CurvePoint before = *(after - 1);
    const double share =
        std::log(seconds / before.seconds) / std::log(after->seconds / before.seconds);
    if (before.error > 0 && after->error > 0) {
        return before.error * std::pow(after->error / before.error, share);
    }
    return before.error + share * (after->error - before.error);
}

}  // namespace bench
