// The table of a run: for people at a terminal, or as Markdown.
#include "conformance_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace conformance {
namespace {

std::string spread_cell(const Spread& s) {
    return fmt::format("{:.2f} / {:.2f}", 100 * s.median, 100 * s.p95);
}

std::string ratio_cell(const Row& row, std::size_t channel) {
    return fmt::format("{:+.1f} / {:.1f}", 100 * (row.found.mean_ratio[channel] - 1),
                       100 * row.found.channels[channel].median);
}

std::string verdict(const Row& row) {
    if (!row.failure.empty()) return "FAILED";
    return row.passes_limits() ? "ok" : "MISS";
}

}  // namespace

bool Row::passes_limits() const {
    return failure.empty() && refused == 0 && is_below(found.luminance, limit);
}

std::string table_head(TableForm form) {
    if (form == TableForm::Markdown) {
        return "| scene | integrator | median / p95, % | R mean / median, % | G | B | "
               "own noise, % | passes | |\n"
               "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    }
    return fmt::format("{:<6} {:<30} {:<6} {:>15} {:>13} {:>13} {:>13} {:>13} {:>7} {:>6}\n", "",
                       "scene", "by", "median/p95 %", "R mean/med %", "G", "B", "own noise %",
                       "passes", "s");
}

std::string table_line(const Row& row, TableForm form) {
    const std::string main = spread_cell(row.found.luminance), noise = spread_cell(row.noise);
    if (form == TableForm::Markdown) {
        return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.scene,
                           row.integrator, main, ratio_cell(row, 0), ratio_cell(row, 1),
                           ratio_cell(row, 2), noise, row.passes, verdict(row));
    }
    return fmt::format("{:<6} {:<30} {:<6} {:>15} {:>13} {:>13} {:>13} {:>13} {:>7} {:>6.1f}\n",
                       verdict(row), row.scene, row.integrator, main, ratio_cell(row, 0),
                       ratio_cell(row, 1), ratio_cell(row, 2), noise, row.passes, row.seconds);
}

std::string table_notes(const std::vector<Row>& rows) {
    const auto passed =
        std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.passes_limits(); });
    std::string text = fmt::format("\n{} of {} within the limits\n", passed, rows.size());
    const auto note = [&text](const Row& row, const std::string& what) {
        text += fmt::format("- {} by {}: {}\n", row.scene, row.integrator, what);
    };
    for (const Row& row : rows) {
        if (!row.failure.empty()) note(row, row.failure);
        if (!row.settled) note(row, "its own noise is still too high for a verdict");
        if (row.refused > 0)
            note(row, fmt::format("{} negative or non-finite numbers", row.refused));
        if (row.reference_negatives > 0)
            note(row, fmt::format("{} negative numbers in the reference", row.reference_negatives));
        for (const std::string& warning : row.warnings)
            note(row, warning);
    }
    return text;
}

}  // namespace conformance
