// `aips-bench table`: a study's comparisons as Markdown.
#pragma once

#include <string>

#include "study_file.h"

namespace bench {

/// For each scene and variant one table on `clock` ("cpu" or "wall"): errors of each method at each
/// budget (geometric mean over seeds) and ratios to the baseline with their intervals.
std::string comparison_table(const Json& summary, const std::string& clock);

}  // namespace bench
