// `aips-bench paper`: the figures of Liu and Zheng 2014 redone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exit_code.h"
#include "experiment.h"
#include "lxs/host/console_log.h"
#include "lxs/host/interruption.h"
#include "lxs/host/plugin_library.h"
#include "method_table.h"

namespace bench {

inline constexpr const char* kPaperSchema = "aips-bench-paper-1";

struct PaperRequest {
    std::vector<Experiment> experiments;  ///< before scaling
    double scale = 1;                     ///< above 0, at most 1
    unsigned seeds = 3;
    unsigned threads = 0;              ///< 0: all processors
    double reference_seconds = 60;     ///< wall time that a scene's references have at least
    bool any_build = false;            ///< runs of other builds count as done
    std::filesystem::path folder;      ///< of what is written
    std::filesystem::path references;  ///< folder of all references
    std::filesystem::path scene_table, scene_folder;
};

/// Renders what is missing, then writes DIR/paper.json and DIR/paper.md and prints the latter.
/// Success, RunsFailed or Interrupted. Throws StudyError, lxs::OutputFailure.
ExitCode redo_paper(const PaperRequest& request, const MethodTable& table,
                    const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                    lxs::ConsoleLog& log);

}  // namespace bench
