// What a report draws of the errors over time: curves, their slopes, and equal-error speed-ups.
#include "report_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "equal_error_speedup.h"
#include "power_law_fit.h"
#include "run_group.h"

namespace bench {
namespace {

struct SeedCurve {
    Json seed;
    std::vector<CurvePoint> points;  ///< in order of time
};

/// What a curve shows.
struct Figure {
    std::string part, clock, metric;
};

std::vector<CurvePoint> curve_of(const Json& run, const Figure& figure) {
    std::vector<CurvePoint> points;
    for (const Json& snapshot : run.at("snapshots")) {
        const Json& error = snapshot.at("error");
        if (error.is_null() || error.at(figure.part).is_null()) continue;
        points.push_back({snapshot.at(figure.clock + "_s"),
                          error.at(figure.part).at(figure.metric).get<double>()});
    }
    return points;
}

std::vector<SeedCurve> curves_of(const Json& runs, const Json& study, const RunGroup& group,
                                 const Figure& figure) {
    std::vector<SeedCurve> curves;
    for (const Json& seed : study.at("seeds")) {
        const Json* run = find_run(runs, group, seed);
        if (run == nullptr) continue;
        SeedCurve curve{seed, curve_of(*run, figure)};
        if (!curve.points.empty()) curves.push_back(std::move(curve));
    }
    return curves;
}

std::vector<Figure> figures_of(const Json& study) {
    std::vector<Figure> figures;
    for (const char* part : kReportParts) {
        for (const std::string& clock : clocks_of(study)) {
            for (const char* metric : kReportMetrics)
                figures.push_back({part, clock, metric});
        }
    }
    return figures;
}

template <class Action>
void for_each_curve(const Json& study, const Action& action) {
    const std::vector<Figure> figures = figures_of(study);
    for (const Json& scene : study.at("scenes")) {
        for (const Json& variant : study.at("variants")) {
            for (const Json& method : study.at("methods")) {
                for (const Figure& figure : figures)
                    action(RunGroup{scene, method, variant}, figure);
            }
        }
    }
}

Json entry_of(const RunGroup& group, const Figure& figure) {
    return {{"scene", group.scene}, {"variant", group.variant}, {"method", group.method},
            {"part", figure.part},  {"clock", figure.clock},    {"metric", figure.metric}};
}

/// Half the smallest budget and the budgets: about where every run took snapshots.
std::vector<double> common_times(const Json& study) {
    auto times = study.at("budgets_s").get<std::vector<double>>();
    if (!times.empty()) times.insert(times.begin(), times.front() / 2);
    return times;
}

/// Where every seed has a positive error.
std::vector<CurvePoint> geometric_mean(const std::vector<SeedCurve>& curves,
                                       const std::vector<double>& times) {
    std::vector<CurvePoint> mean;
    for (const double seconds : times) {
        double logs = 0;
        bool all = true;
        for (const SeedCurve& curve : curves) {
            const double error = error_at(curve.points, seconds).value_or(0);
            all = all && error > 0;
            if (all) logs += std::log(error) / double(curves.size());
        }
        if (all) mean.push_back({seconds, std::exp(logs)});
    }
    return mean;
}

Json pairs(const std::vector<CurvePoint>& points) {
    Json list = Json::array();
    for (const auto& [seconds, error] : points)
        list.push_back({seconds, error});
    return list;
}

void add_slopes(const std::vector<SeedCurve>& curves, const std::vector<double>& times,
                Json& entry) {
    std::vector<double> slopes;
    for (const SeedCurve& curve : curves) {
        if (const auto law = fit_power_law(geometric_mean({curve}, times)))
            slopes.push_back(law->slope);
    }
    for (const char* key : {"slope", "slope_low", "slope_high"})
        entry[key] = nullptr;
    if (slopes.empty()) return;
    double mean = 0;
    for (const double slope : slopes)
        mean += slope / double(slopes.size());
    const auto [low, high] = std::minmax_element(slopes.begin(), slopes.end());
    entry["slope"] = mean;
    entry["slope_low"] = *low;
    entry["slope_high"] = *high;
}

/// Of the seeds that both have.
std::vector<Speedup> speedups_of(const std::vector<SeedCurve>& curves,
                                 const std::vector<SeedCurve>& baseline, double budget_s) {
    std::vector<Speedup> speedups;
    for (const SeedCurve& curve : curves) {
        const auto same = std::find_if(baseline.begin(), baseline.end(),
                                       [&](const auto& base) { return base.seed == curve.seed; });
        if (same == baseline.end()) continue;
        if (const auto speedup = equal_error_speedup(curve.points, same->points, budget_s))
            speedups.push_back(*speedup);
    }
    return speedups;
}

Json bound_text(Bound bound) {
    switch (bound) {
        case Bound::AtLeast:
            return "at least";
        case Bound::AtMost:
            return "at most";
        case Bound::None:
            break;
    }
    return nullptr;
}

}  // namespace

std::vector<std::string> clocks_of(const Json& study) {
    const std::string clock = study.at("clock");
    return clock == "both" ? std::vector<std::string>{"cpu", "wall"}
                           : std::vector<std::string>{clock};
}

Json report_curves(const Json& runs, const Json& study) {
    Json list = Json::array();
    const std::vector<double> times = common_times(study);
    for_each_curve(study, [&](const RunGroup& group, const Figure& figure) {
        const auto curves = curves_of(runs, study, group, figure);
        if (curves.empty()) return;
        Json entry = entry_of(group, figure);
        entry["mean"] = pairs(geometric_mean(curves, times));
        entry["seeds"] = Json::array();
        for (const auto& [seed, points] : curves)
            entry["seeds"].push_back({{"seed", seed}, {"points", pairs(points)}});
        add_slopes(curves, times, entry);
        list.push_back(std::move(entry));
    });
    return list;
}

Json report_speedups(const Json& runs, const Json& study) {
    Json list = Json::array();
    const std::string baseline = study.at("baseline");
    for_each_curve(study, [&](const RunGroup& group, const Figure& figure) {
        if (group.method == baseline) return;
        const auto curves = curves_of(runs, study, group, figure);
        const auto base = curves_of(runs, study, {group.scene, baseline, group.variant}, figure);
        for (const double budget_s : study.at("budgets_s")) {
            const auto mean = mean_speedup(speedups_of(curves, base, budget_s));
            if (!mean) continue;
            Json entry = entry_of(group, figure);
            entry["budget_s"] = budget_s;
            entry["speedup"] = mean->factor;
            entry["low"] = mean->low ? Json(*mean->low) : Json();
            entry["high"] = mean->high ? Json(*mean->high) : Json();
            entry["bound"] = bound_text(mean->bound);
            entry["seeds"] = mean->seeds;
            list.push_back(std::move(entry));
        }
    });
    return list;
}

}  // namespace bench
