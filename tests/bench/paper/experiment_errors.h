// What an experiment's runs say: errors at equal passes and at equal time, time and memory.
#pragma once

#include <string>

#include "experiment.h"
#include "study_file.h"

namespace bench {

/// "scenes" of an experiment in paper.json (docs/reference/benchmark-files.md): for each of its
/// scenes the time at which runs are compared and a row for each case. `runs` are all of its runs,
/// failed ones too.
Json experiment_errors(const Experiment& experiment, const Json& runs, unsigned seeds);

/// The run of a case on a scene with a seed; null if there is none or it failed.
const Json* find_paper_run(const Json& runs, const std::string& scene, const std::string& name,
                           unsigned seed);

}  // namespace bench
