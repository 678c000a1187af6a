// `aips-bench run`: renders what a study lacks, measures and summarises it.
#pragma once

#include <filesystem>

#include "exit_code.h"
#include "lxs/host/console_log.h"
#include "lxs/host/interruption.h"
#include "lxs/host/plugin_library.h"
#include "method_table.h"
#include "study_plan.h"

namespace bench {

struct RunRequest {
    Study study;
    bool photon_part = false;          ///< photon methods write their photons' part
    std::filesystem::path folder;      ///< of the study
    std::filesystem::path references;  ///< folder of all references
};

/// Success, RunsFailed or Interrupted. Throws StudyError, lxs::OutputFailure.
ExitCode run_study(const RunRequest& request, const MethodTable& table,
                   const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                   lxs::ConsoleLog& log);

}  // namespace bench
