// `aips-bench agreement`: do a study's methods agree with the references within noise and bias?
#pragma once

#include <filesystem>

#include "exit_code.h"
#include "lxs/host/console_log.h"
#include "study_file.h"

namespace bench {

inline constexpr const char* kAgreementSchema = "aips-bench-agreement-1";

struct AgreementRequest {
    std::filesystem::path folder;          ///< of the study
    std::filesystem::path references;      ///< folder of all references
    std::filesystem::path smaller_radius;  ///< study of the baseline at a smaller radius, or empty
    std::filesystem::path scene_table;
};

/// Writes DIR/agreement.json (docs/reference/benchmark-files.md) and prints it as Markdown.
/// Success or MethodsDiffer. Throws StudyError, lxs::OutputFailure.
ExitCode test_agreement(const AgreementRequest& request, lxs::ConsoleLog& log);

}  // namespace bench
