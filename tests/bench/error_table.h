// `aips-bench table --error`: what methods leave of an error, all scenes in one table as Markdown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study_file.h"

namespace bench {

/// A study whose runs are shown.
struct ShownStudy {
    Json summary;
    std::string name;  ///< of its column; empty: those of its methods
};

/// What a cell is.
struct ShownError {
    std::string figure;              ///< key of `at_budget`: "relmse_rest", "relmse", "mse", "rmse"
    std::string clock;               ///< "cpu" or "wall"
    std::optional<double> budget_s;  ///< none: the longest of the first study
};

/// A row for each scene, a column for each method (and variant, where a study has several), runs of
/// columns with one name together. A cell is the mean over seeds, "-" where noise of the references
/// makes it negative, empty where there is none; the least of a row is bold. The last row has
/// geometric means over the last column, of scenes where both are positive. Throws StudyError
/// without any study or budget.
std::string error_table(const std::vector<ShownStudy>& studies, const ShownError& shown);

}  // namespace bench
