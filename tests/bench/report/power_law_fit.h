// How fast errors fall: the slope of a straight line through points in log time and log error.
#pragma once

#include <optional>
#include <span>

#include "budget_curve.h"

namespace bench {

/// error = factor x seconds^slope; -1 is what independent samples give a squared error.
struct PowerLaw {
    double slope = 0;
    double factor = 0;  ///< error at one second
};

/// Least squares in log time and log error, over the points with positive error. Nothing with fewer
/// than two of them, or if all are at one time.
std::optional<PowerLaw> fit_power_law(std::span<const CurvePoint> curve);

}  // namespace bench
