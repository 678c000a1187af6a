// One step of a study: a run is found or rendered, and measured.
#pragma once

#include <filesystem>
#include <optional>

#include "run_errors.h"
#include "run_record.h"

namespace bench {

/// The run's document, "file" added, as it now stands in `folder`; rendered unless a run of these
/// settings and this build is there. Nothing if the user interrupted it; "status" tells of failure.
/// Throws StudyError, lxs::OutputFailure.
std::optional<Json> carry_out_run(const std::filesystem::path& folder, const RunSettings& settings,
                                  const Build& build, ReferenceCache& references);

}  // namespace bench
