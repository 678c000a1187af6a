// How much sooner a method is as good as the baseline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "budget_curve.h"

namespace bench {

/// What is known of a figure that lies beyond what was measured.
enum class Bound : std::uint8_t { None, AtLeast, AtMost };

/// Seconds(baseline) / seconds(method) to reach an error; above 1 the method is faster.
struct Speedup {
    double factor = 1;
    Bound bound = Bound::None;  ///< AtLeast: reached before the first snapshot; AtMost: not at all
};

/// Curves are straight in log time and log error; a curve reaches an error when it first is at or
/// below it. The error is the one that the baseline has at `seconds`. Nothing if that isn't known
/// or not positive, or the method has no points.
std::optional<Speedup> equal_error_speedup(std::span<const CurvePoint> method,
                                           std::span<const CurvePoint> baseline, double seconds);

/// Over seeds.
struct MeanSpeedup {
    double factor = 1;  ///< geometric mean; a bound of it, if `bound` says so
    /// 95 % t-interval; of a bound only the end that it leaves certain. Nothing with one seed.
    std::optional<double> low, high;
    Bound bound = Bound::None;
    std::size_t seeds = 0;
};

/// Nothing without seeds, or if some are bounded from below and others from above.
std::optional<MeanSpeedup> mean_speedup(const std::vector<Speedup>& seeds);

}  // namespace bench
