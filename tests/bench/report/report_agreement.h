// What a report says of `aips-bench agreement`.
#pragma once

#include <filesystem>

#include "study_file.h"

namespace bench {

/// null if the study's folder has no agreement.json, else `created`, `is_older` (than the study's
/// last run, so that it may speak of other images), `significance`, `decisive`, `claims_bias` and
/// `tests`: as in the file. Throws StudyError if it is damaged.
Json report_agreement(const std::filesystem::path& study_folder, const Json& summary);

}  // namespace bench
