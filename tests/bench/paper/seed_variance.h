// How much a case's images differ from seed to seed: its noise, without any reference.
#pragma once

#include <filesystem>

#include "experiment.h"
#include "study_file.h"

namespace bench {

/// Adds to the rows of `scene` (an entry of experiment_errors) "relative_variance": mean over
/// pixels and channels of the sample variance over seeds of the last snapshots, divided by (M^2 +
/// epsilon), M being the mean of the case's images and of those that it is compared with; and
/// "variance_ratio" to the variance of the latter, divided likewise. Both null where either has
/// fewer than two seeds. `study` is the runs' folder.
void add_seed_variance(const Experiment& experiment, const Json& runs, unsigned seeds,
                       const std::filesystem::path& study, Json& scene);

}  // namespace bench
