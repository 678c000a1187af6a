// What an experiment's runs say: errors at equal passes and at equal time, time and memory.
#include "experiment_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "budget_curve.h"
#include "error_ratio.h"

namespace bench {
namespace {

using Runs = std::vector<const Json*>;  ///< of a case on a scene, one for each seed; null: none
using Errors = std::vector<std::optional<double>>;

Runs runs_of(const Json& runs, const std::string& scene, const std::string& name, unsigned seeds) {
    Runs found;
    for (unsigned seed = 1; seed <= seeds; ++seed)
        found.push_back(find_paper_run(runs, scene, name, seed));
    return found;
}

/// Which error of a snapshot is meant.
struct Metric {
    std::string part;    ///< "image" or "photons"
    std::string figure;  ///< one of kFigures
};

constexpr std::array kFigures{"mse", "relmse", "relmse_rest"};

std::optional<double> snapshot_figure(const Json& snapshot, const Metric& metric) {
    const Json& error = snapshot.at("error");
    if (error.is_null() || error.at(metric.part).is_null()) return std::nullopt;
    return error.at(metric.part).at(metric.figure).get<double>();
}

std::optional<double> error_after(const Json* run, std::uint64_t passes, const Metric& metric) {
    if (run == nullptr) return std::nullopt;
    for (const Json& snapshot : run->at("snapshots")) {
        if (snapshot.at("pass") == passes) return snapshot_figure(snapshot, metric);
    }
    return std::nullopt;
}

std::optional<double> error_at_time(const Json* run, double cpu_s, const Metric& metric) {
    if (run == nullptr) return std::nullopt;
    std::vector<CurvePoint> curve;
    for (const Json& snapshot : run->at("snapshots")) {
        const auto error = snapshot_figure(snapshot, metric);
        if (error) curve.push_back({snapshot.at("cpu_s"), *error});
    }
    return error_at(curve, cpu_s);
}

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

/// Arithmetic: an error may be negative, as noise of the references makes it.
std::optional<double> mean_error(const Errors& errors) {
    double sum = 0, count = 0;
    for (const auto& error : errors) {
        if (!error) continue;
        sum += *error;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / count;
}

using ErrorOf = std::function<std::optional<double>(const Json* run, const Metric& metric)>;

/// Every figure of a case's runs with its ratio to `against`.
Json compared(const Runs& runs, const Runs& against, const std::string& part,
              const ErrorOf& error_of) {
    Json figures = Json::object();
    for (const char* figure : kFigures) {
        Errors errors, baseline;
        for (std::size_t seed = 0; seed < runs.size(); ++seed) {
            errors.push_back(error_of(runs[seed], {part, figure}));
            baseline.push_back(error_of(against[seed], {part, figure}));
        }
        const ErrorRatio ratio = error_ratio(errors, baseline);
        figures[figure] = {{"mean", or_null(mean_error(errors))},
                           {"ratio", or_null(ratio.ratio)},
                           {"low", or_null(ratio.low)},
                           {"high", or_null(ratio.high)},
                           {"seeds", ratio.used},
                           {"left_out", ratio.left_out}};
    }
    return figures;
}

/// Arithmetic mean over the runs that have the figure.
Json mean_figure(const Runs& runs, const std::function<Json(const Json& run)>& figure) {
    double sum = 0, count = 0;
    for (const Json* run : runs) {
        const Json value = run == nullptr ? Json() : figure(*run);
        if (!value.is_number()) continue;
        sum += value.get<double>();
        ++count;
    }
    return count > 0 ? Json(sum / count) : Json();
}

Json statistic(const Runs& runs, const char* name) {
    return mean_figure(
        runs, [&](const Json& run) { return run.at("integrator_statistics").value(name, Json()); });
}

Json total(const Runs& runs, const char* group, const char* name) {
    return mean_figure(runs, [&](const Json& run) { return run.at(group).at(name); });
}

/// Mean errors after the passes at which the first run has snapshots, over the runs that have one
/// there too.
Json curve_of(const Runs& runs, const std::string& part) {
    Json curve = Json::array();
    const auto first = std::find_if(runs.begin(), runs.end(), [](const Json* r) { return r; });
    if (first == runs.end()) return curve;
    for (const Json& snapshot : (*first)->at("snapshots")) {
        const std::uint64_t pass = snapshot.at("pass");
        Json point{{"pass", pass}};
        for (const char* figure : kFigures) {
            Errors errors;
            for (const Json* run : runs)
                errors.push_back(error_after(run, pass, {part, figure}));
            point[figure] = or_null(mean_error(errors));
        }
        curve.push_back(std::move(point));
    }
    return curve;
}

/// The most CPU time that all runs have used.
double common_time(const Experiment& experiment, const Json& runs, const std::string& scene,
                   unsigned seeds) {
    double least = std::numeric_limits<double>::infinity();
    for (const PaperCase& one : experiment.cases) {
        for (const Json* run : runs_of(runs, scene, one.name, seeds)) {
            if (run == nullptr) continue;
            least = std::min(least, run->at("snapshots").back().at("cpu_s").get<double>());
        }
    }
    return least;
}

Json row_of(const Experiment& experiment, const PaperCase& one, const Runs& runs,
            const Runs& against, double cpu_s) {
    Json row{{"case", one.name}, {"label", one.label}, {"against", one.against}};
    row["equal_passes"] = nullptr;
    if (experiment.passes > 0) {
        row["equal_passes"] =
            compared(runs, against, experiment.part, [&](const Json* run, const Metric& metric) {
                return error_after(run, experiment.passes, metric);
            });
    }
    row["equal_time"] = compared(
        runs, against, experiment.part,
        [&](const Json* run, const Metric& metric) { return error_at_time(run, cpu_s, metric); });
    row["passes"] = total(runs, "totals", "passes");
    row["cpu_s"] = total(runs, "phases", "render_cpu_s");
    row["peak_memory_bytes"] =
        mean_figure(runs, [](const Json& run) { return run.at("peak_memory_bytes"); });
    row["guide_bytes"] = statistic(runs, "guide_bytes");
    row["guide_nodes"] = statistic(runs, "guide_nodes");
    row["curve"] = experiment.passes > 0 ? curve_of(runs, experiment.part) : Json::array();
    return row;
}

}  // namespace

const Json* find_paper_run(const Json& runs, const std::string& scene, const std::string& name,
                           unsigned seed) {
    for (const Json& run : runs) {
        const Json& settings = run.at("settings");
        if (run.at("status") == "done" && settings.at("scene") == scene &&
            settings.at("method") == name && settings.at("seed") == seed)
            return &run;
    }
    return nullptr;
}

Json experiment_errors(const Experiment& experiment, const Json& runs, unsigned seeds) {
    Json scenes = Json::array();
    for (const PaperScene& scene : experiment.scenes) {
        const double cpu_s =
            scene.seconds > 0 ? scene.seconds : common_time(experiment, runs, scene.name, seeds);
        Json rows = Json::array();
        for (const PaperCase& one : experiment.cases) {
            rows.push_back(row_of(experiment, one, runs_of(runs, scene.name, one.name, seeds),
                                  runs_of(runs, scene.name, one.against, seeds), cpu_s));
        }
        scenes.push_back({{"scene", scene.name},
                          {"equal_time_s", std::isfinite(cpu_s) ? Json(cpu_s) : Json()},
                          {"rows", std::move(rows)}});
    }
    return scenes;
}

}  // namespace bench
