// Runs of a study that differ by their seed alone.
#pragma once

#include <string>

#include "study_file.h"

namespace bench {

/// A method on a scene in a variant ("fixed" or "shipped").
struct RunGroup {
    std::string scene, method, variant;
};

/// The group's run with a seed among `runs`, null if there is none. A run of a method without
/// variants counts in both.
const Json* find_run(const Json& runs, const RunGroup& group, const Json& seed);

}  // namespace bench
