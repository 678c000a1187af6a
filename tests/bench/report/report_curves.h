// What a report draws of the errors over time: curves, their slopes, and equal-error speed-ups.
#pragma once

#include <string>
#include <vector>

#include "study_file.h"

namespace bench {

/// Figures that the report compares methods by.
inline constexpr const char* kReportMetrics[] = {"relmse", "mse", "relmse_rest"};

/// What errors are measured of: the whole image, or what photons carry.
inline constexpr const char* kReportParts[] = {"image", "photons"};

/// Clocks that the study's budgets are counted on.
std::vector<std::string> clocks_of(const Json& study);

/// A list with one entry for each scene, variant, method, part, clock and metric of which there are
/// points: `mean` (geometric mean over seeds at equal times; pairs of seconds and error), `seeds`
/// (list of `seed` and `points`: the snapshots' own), `slope`, `slope_low`, `slope_high`: mean,
/// least and largest slope of the seeds' own power laws, from the first budget's half on.
/// `runs` are those that are done.
Json report_curves(const Json& runs, const Json& study);

/// A list with one entry for each scene, variant, method but the baseline, part, clock, metric
/// and budget: `speedup`, `low`, `high` (null where unknown), `bound` (null, "at least" or "at
/// most"), `seeds`.
Json report_speedups(const Json& runs, const Json& study);

}  // namespace bench
