// The error at a budget, between the snapshots that a run really took.
#pragma once

#include <optional>
#include <span>

namespace bench {

/// A snapshot's time (seconds, > 0) and error.
struct CurvePoint {
    double seconds = 0;
    double error = 0;
};

/// Interpolated at `seconds`, straight in log time and log error; straight in log time alone where
/// an error is not positive. The points are in order of time. Nothing outside of them.
std::optional<double> error_at(std::span<const CurvePoint> curve, double seconds);

}  // namespace bench
