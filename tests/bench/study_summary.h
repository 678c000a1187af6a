// DIR/summary.json: all that a study found, for reports.
#pragma once

#include <filesystem>

#include "method_table.h"
#include "run_errors.h"
#include "study_plan.h"

namespace bench {

inline constexpr const char* kSummarySchema = "aips-bench-summary-1";

/// The study's settings as its files say them.
Json to_json(const Study& study);

/// `runs` are all of the study's runs, failed ones too, in their order.
Json summarise(const std::filesystem::path& folder, const Study& study, const MethodTable& table,
               const Json& runs, ReferenceCache& references);

}  // namespace bench
