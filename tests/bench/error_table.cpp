// Cells by scene and column, gathered over all studies before any is written.
#include "error_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace bench {
namespace {

/// Sum and count of the runs of a cell.
struct Cell {
    double sum = 0;
    int count = 0;

    std::optional<double> mean() const {
        return count > 0 ? std::optional(sum / count) : std::nullopt;
    }
    std::optional<double> positive() const {
        const auto value = mean();
        return value && *value > 0 ? value : std::nullopt;
    }
};

/// Without an exponent up to 9999.
std::string two_digits(double value) {
    const std::string text = fmt::format("{:.2g}", value);
    const double rounded = std::stod(text);
    return rounded >= 100 && rounded < 1e4 ? fmt::format("{:.0f}", rounded) : text;
}

/// Scenes and columns in the order in which they came.
class Table {
  public:
    void add(const std::string& scene, const std::string& column, double value) {
        Cell& cell = cells_[{index(scenes_, scene), index(columns_, column)}];
        cell.sum += value;
        ++cell.count;
    }

    bool is_empty() const { return cells_.empty(); }

    std::string text() const {
        std::string text = "| scene |", rule = "| --- |";
        for (const std::string& column : columns_) {
            text += fmt::format(" {} |", column);
            rule += " --- |";
        }
        text += "\n" + rule + "\n";
        for (std::size_t scene = 0; scene < scenes_.size(); ++scene)
            text += row(scene);
        return text + means();
    }

  private:
    static std::size_t index(std::vector<std::string>& names, const std::string& name) {
        const auto at = std::ranges::find(names, name);
        const auto index = static_cast<std::size_t>(at - names.begin());
        if (at == names.end()) names.push_back(name);
        return index;
    }

    Cell cell(std::size_t scene, std::size_t column) const {
        const auto found = cells_.find({scene, column});
        return found == cells_.end() ? Cell{} : found->second;
    }

    std::string row(std::size_t scene) const {
        double least = INFINITY;
        for (std::size_t column = 0; column < columns_.size(); ++column)
            least = std::min(least, cell(scene, column).positive().value_or(least));
        std::string text = fmt::format("| {} |", scenes_[scene]);
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const Cell shown = cell(scene, column);
            const auto value = shown.positive();
            const char* const bold = value == least ? "**" : "";
            if (value)
                text += fmt::format(" {}{}{} |", bold, two_digits(*value), bold);
            else
                text += shown.count > 0 ? " - |" : " |";
        }
        return text + "\n";
    }

    std::string means() const {
        std::string text = "| over the last, geometric mean |";
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            double logs = 0;
            int count = 0;
            for (std::size_t scene = 0; scene < scenes_.size(); ++scene) {
                const auto value = cell(scene, column).positive();
                const auto last = cell(scene, columns_.size() - 1).positive();
                if (!value || !last) continue;
                logs += std::log(*value / *last);
                ++count;
            }
            text += count > 0 ? fmt::format(" {:.2g} |", std::exp(logs / count)) : " |";
        }
        return text + "\n";
    }

    std::vector<std::string> scenes_, columns_;
    std::map<std::pair<std::size_t, std::size_t>, Cell> cells_;
};

std::string column_of(const ShownStudy& study, const Json& settings) {
    if (!study.name.empty()) return study.name;
    const std::string method = settings.at("method"), variant = settings.at("variant");
    const bool several = study.summary.at("study").at("variants").size() > 1;
    return several && variant != "any" ? fmt::format("{}, {}", method, variant) : method;
}

double longest_budget(const ShownStudy& study) {
    double longest = 0;
    for (const double budget_s : study.summary.at("study").at("budgets_s"))
        longest = std::max(longest, budget_s);
    return longest;
}

}  // namespace

std::string error_table(const std::vector<ShownStudy>& studies, const ShownError& shown) {
    const double budget_s = shown.budget_s ? *shown.budget_s : longest_budget(studies.front());
    Table table;
    for (const ShownStudy& study : studies) {
        for (const Json& run : study.summary.at("runs")) {
            if (run.at("status") != "done") continue;
            const Json& settings = run.at("settings");
            for (const Json& entry : run.at("at_budget")) {
                if (entry.at("clock") != shown.clock || entry.at("budget_s") != budget_s ||
                    entry.at("image").is_null())
                    continue;
                const Json& value = entry.at("image").at(shown.figure);
                if (value.is_number())
                    table.add(settings.at("scene"), column_of(study, settings), value);
            }
        }
    }
    if (table.is_empty())
        throw StudyError(fmt::format("no error after {:g} {} seconds", budget_s, shown.clock));
    return fmt::format("{} after {:g} {} seconds, mean over seeds:\n\n", shown.figure, budget_s,
                       shown.clock) +
           table.text();
}

}  // namespace bench
