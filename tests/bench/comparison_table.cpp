// `aips-bench table`: a study's comparisons as Markdown.
#include "comparison_table.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace bench {
namespace {

/// Whose figures a row shows.
struct Row {
    std::string scene, variant, method;
    std::string clock;
    double budget_s = 0;
};

bool is_about(const Json& entry, const Row& row) {
    return entry.at("scene") == row.scene && entry.at("variant") == row.variant &&
           entry.at("method") == row.method && entry.at("clock") == row.clock &&
           entry.at("budget_s") == row.budget_s;
}

std::string ratio_text(const Json& summary, const Row& row, const char* part, const char* metric) {
    for (const Json& entry : summary.at("comparisons")) {
        if (!is_about(entry, row) || entry.at("part") != part || entry.at("metric") != metric)
            continue;
        const double ratio = entry.at("ratio");
        if (entry.at("low").is_null()) return fmt::format("{:.3g}", ratio);
        return fmt::format("{:.3g} [{:.3g}, {:.3g}]", ratio, entry.at("low").get<double>(),
                           entry.at("high").get<double>());
    }
    return "-";
}

std::string number_text(const std::optional<double>& value) {
    return value ? fmt::format("{:.3g}", *value) : "-";
}

/// Geometric mean over seeds of a figure at the row's budget.
std::optional<double> mean_at_budget(const Json& summary, const Row& row, const char* figure) {
    double logs = 0;
    int count = 0;
    for (const Json& run : summary.at("runs")) {
        if (run.at("status") != "done") continue;
        const Json& settings = run.at("settings");
        const Json& variant = settings.at("variant");
        if (settings.at("scene") != row.scene || settings.at("method") != row.method ||
            (variant != row.variant && variant != "any"))
            continue;
        for (const Json& entry : run.at("at_budget")) {
            if (entry.at("clock") != row.clock || entry.at("budget_s") != row.budget_s ||
                entry.at("image").is_null())
                continue;
            const Json& value = entry.at("image").at(figure);
            if (!value.is_number() || value.get<double>() <= 0) continue;
            logs += std::log(value.get<double>());
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return std::exp(logs / count);
}

std::optional<double> seed_figure(const Json& summary, const Row& row, const char* figure) {
    for (const Json& entry : summary.at("seed_statistics")) {
        if (is_about(entry, row) && !entry.at("image").is_null())
            return entry.at("image").at(figure).get<double>();
    }
    return std::nullopt;
}

std::string row_text(const Json& summary, const Row& row) {
    return fmt::format("| {} | {:g} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.method,
                       row.budget_s, number_text(mean_at_budget(summary, row, "mse")),
                       number_text(mean_at_budget(summary, row, "relmse")),
                       number_text(seed_figure(summary, row, "rel_bias2")),
                       number_text(seed_figure(summary, row, "rel_variance")),
                       ratio_text(summary, row, "image", "mse"),
                       ratio_text(summary, row, "image", "relmse"),
                       ratio_text(summary, row, "photons", "relmse"),
                       number_text(mean_at_budget(summary, row, "efficiency_relmse")));
}

std::string heading(const std::string& scene, const std::string& variant, const std::string& clock,
                    const std::string& baseline) {
    const char* meaning =
        variant == "fixed" ? "one fixed radius for all" : "radius schedules as shipped";
    return fmt::format(
        "## {}: {} ({} seconds)\n\n"
        "Ratios are to {} at equal time, below 1 is better; [95 % interval over seeds].\n\n"
        "| method | {} s | MSE | relMSE | relative bias^2 | relative variance | MSE ratio | "
        "relMSE ratio | photon part, relMSE ratio | efficiency 1/(relMSE s) |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        scene, meaning, clock, baseline, clock);
}

}  // namespace

std::string comparison_table(const Json& summary, const std::string& clock) {
    const Json& study = summary.at("study");
    std::string text;
    for (const Json& scene : study.at("scenes")) {
        for (const Json& variant : study.at("variants")) {
            text += heading(scene, variant, clock, study.at("baseline"));
            for (const Json& method : study.at("methods")) {
                for (const double budget_s : study.at("budgets_s"))
                    text += row_text(summary, {scene, variant, method, clock, budget_s});
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace bench
